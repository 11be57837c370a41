/* Loaded before eglretrace (LD_PRELOAD), it writes down what each frame took: after eglSwapBuffers and glFinish, the processor time that
   the process has used until then, in nanoseconds, goes into the file of the variable FRAME_TIMES, a line each. The retracer finds the
   functions of EGL and GL by their names, so this file answers for dlsym and eglGetProcAddress. With NO_GL=1 the functions of GL do
   nothing, but for those that ask: what a frame takes then is the retracer's own share. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef void (*Function)(void);

static unsigned (*swap)(void*, void*);
static Function (*named)(const char*);

static long nothing(void) {
    return 0;
}

static int is(const char* name, const char* other) {
    return strcmp(name, other) == 0;
}

static int begins(const char* name, const char* with) {
    return strncmp(name, with, strlen(with)) == 0;
}

static int left_out(const char* name) {
    return getenv("NO_GL") && begins(name, "gl") && !begins(name, "glGet") && !begins(name, "glIs");
}

static void note_time(void) {
    static FILE* file;
    struct timespec now;
    if (!file)
        file = fopen(getenv("FRAME_TIMES"), "w");
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    fprintf(file, "%lld\n", now.tv_sec * 1000000000ll + now.tv_nsec);
}

static unsigned swap_and_note(void* display, void* surface) {
    const unsigned swapped = swap(display, surface);
    const Function finish = named ? named("glFinish") : NULL;
    if (finish)
        finish();
    note_time();
    return swapped;
}

/* What the caller gets for a function that it asked for by name. */
static void* instead_of(const char* name, void* function);

static Function ask(const char* name) {
    Function found = named(name);
    void* answer;
    memcpy(&answer, &found, sizeof answer);
    answer = instead_of(name, answer);
    memcpy(&found, &answer, sizeof answer);
    return found;
}

static void* instead_of(const char* name, void* function) {
    if (!function)
        return NULL;
    if (is(name, "eglSwapBuffers")) {
        memcpy(&swap, &function, sizeof function);
        return (void*)swap_and_note;
    }
    if (is(name, "eglGetProcAddress")) {
        memcpy(&named, &function, sizeof function);
        return (void*)ask;
    }
    return left_out(name) ? (void*)nothing : function;
}

void* dlsym(void* library, const char* name) {
    static void* (*found_by)(void*, const char*);
    if (!found_by) {
        void* own = dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34");
        if (!own)
            own = dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5");
        memcpy(&found_by, &own, sizeof own);
    }
    return instead_of(name, found_by(library, name));
}
