/* Loaded before a program (LD_PRELOAD), it makes each run of the program draw what the last one drew. Programs seed their random numbers
   by the time of day and by the number of their process, which are the same in each run. Their pictures move by a clock, which goes by
   what the program does and not by the machine: it stands still while the program computes, goes on by the time that a program asks to
   sleep or waits in vain, and by one millisecond whenever it is read. What a program starts (getimage and getwords of the screen savers)
   works at the speed of the machine, so a program that sleeps wakes up when those have ended. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <poll.h>
#include <stddef.h>
#include <sys/select.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { START = 1700000000, PROCESS = 4242 };
/* Clocks that count from when the machine was started have this; it is less than any machine's own, which glibc waits by. */
enum { UPTIME = 1 };
enum { READING = 1000000, SECOND = 1000000000 }; /* nanoseconds */
/* A program's helpers get this much time in all: some go on as long as the program does. */
enum { PAUSE = 10000000, PAUSES = 1500 };

static long long passed; /* nanoseconds since the start */

static long long on_by(long long nanoseconds) {
    return __atomic_add_fetch(&passed, nanoseconds, __ATOMIC_RELAXED);
}

static struct timespec at(long seconds, long long nanoseconds) {
    struct timespec now = {seconds + (long)(nanoseconds / SECOND), (long)(nanoseconds % SECOND)};
    return now;
}

static long long of(const struct timespec* time) {
    return (long long)time->tv_sec * SECOND + time->tv_nsec;
}

/* glibc's own function of a name. */
static void* own(const char* name) {
    return dlsym(RTLD_NEXT, name);
}

static void sleep_for(const struct timespec* time) {
    syscall(SYS_nanosleep, time, NULL);
}

/* Waits until no helper runs, or the time of the helpers is used up. */
static void wait_for_helpers(void) {
    static int left = PAUSES;
    const struct timespec pause = {0, PAUSE};
    siginfo_t ended;
    const int error = errno;
    while (left > 0) {
        ended.si_pid = 0;
        if (waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid != 0)
            break;
        sleep_for(&pause);
        --left;
    }
    errno = error;
}

pid_t getpid(void) {
    return PROCESS;
}

time_t time(time_t* out) {
    const time_t now = at(START, on_by(READING)).tv_sec;
    if (out)
        *out = now;
    return now;
}

int gettimeofday(struct timeval* restrict out, void* restrict zone) {
    const struct timespec now = at(START, on_by(READING));
    (void)zone;
    out->tv_sec = now.tv_sec;
    out->tv_usec = now.tv_nsec / 1000;
    return 0;
}

int clock_gettime(clockid_t clock, struct timespec* out) {
    *out = at(clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE ? START : UPTIME, on_by(READING));
    return 0;
}

int nanosleep(const struct timespec* asked, struct timespec* left) {
    wait_for_helpers();
    sleep_for(asked);
    on_by(of(asked));
    if (left)
        left->tv_sec = left->tv_nsec = 0;
    return 0;
}

int clock_nanosleep(clockid_t clock, int flags, const struct timespec* asked, struct timespec* left) {
    struct timespec now, rest = {0, 0};
    if ((flags & TIMER_ABSTIME) == 0)
        return nanosleep(asked, left);
    clock_gettime(clock, &now);
    if (of(asked) > of(&now))
        rest = at(0, of(asked) - of(&now));
    return nanosleep(&rest, left);
}

int usleep(useconds_t microseconds) {
    const struct timespec asked = at(0, microseconds * 1000ll);
    return nanosleep(&asked, NULL);
}

unsigned sleep(unsigned seconds) {
    const struct timespec asked = {seconds, 0};
    nanosleep(&asked, NULL);
    return 0;
}

/* Who waits for events with a limit, and gets none, has slept. */
int poll(struct pollfd* files, nfds_t count, int milliseconds) {
    int (*const wait)(struct pollfd*, nfds_t, int) = (int (*)(struct pollfd*, nfds_t, int))own("poll");
    const int ready = wait(files, count, milliseconds);
    if (ready == 0 && milliseconds > 0)
        on_by(milliseconds * 1000000ll);
    return ready;
}

int select(int count, fd_set* restrict in, fd_set* restrict out, fd_set* restrict except, struct timeval* restrict limit) {
    int (*const wait)(int, fd_set*, fd_set*, fd_set*, struct timeval*) =
        (int (*)(int, fd_set*, fd_set*, fd_set*, struct timeval*))own("select");
    const long long asked = limit ? limit->tv_sec * (long long)SECOND + limit->tv_usec * 1000ll : 0;
    const int ready = wait(count, in, out, except, limit);
    if (ready == 0)
        on_by(asked);
    return ready;
}
