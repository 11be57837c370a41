// libGL.so.1, libEGL.so.1, libOpenGL.so.0 and libGLX.so.0 hold nothing: each loads libspangle-dropin.so.0,
// whose functions are found through it.
