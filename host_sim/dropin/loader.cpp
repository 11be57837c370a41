// libGL.so.1, libEGL.so.1, libOpenGL.so.0 and libGLX.so.0 are built from this empty file. Each loads
// libspangle-dropin.so.0, and programs find its functions through them.
