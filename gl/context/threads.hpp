// Locks for data that the threads of a host share. Firmware has one thread, so its locks do nothing and need
// neither code nor data.
#pragma once

#if defined(__STDC_HOSTED__) && __STDC_HOSTED__ && (defined(__unix__) || defined(__APPLE__))
#define SPANGLE_THREAD_LOCAL                                                                                 \
    __thread __attribute__((tls_model("initial-exec"))) // initialisers are constant: no guard needed
#else
#define SPANGLE_THREAD_LOCAL
#endif

#if defined(__STDC_HOSTED__) && __STDC_HOSTED__ && (defined(__unix__) || defined(__APPLE__)) &&              \
    !defined(SPANGLE_FIRMWARE)
#define SPANGLE_THREADS 1
#include <atomic>
#include <pthread.h>
#else
#define SPANGLE_THREADS 0
#endif

namespace spangle::gl {

struct Context;

namespace detail {
extern SPANGLE_THREAD_LOCAL Context* current;
}

#if SPANGLE_THREADS

/// A recursive mutex. The thread that holds it may take it again.
class Lock {
  public:
    void take() {
        const void* const me = &detail::current; // the address differs on each thread
        if (owner_.load(std::memory_order_relaxed) != me) {
            pthread_mutex_lock(&mutex_);
            owner_.store(me, std::memory_order_relaxed);
        }
        ++recursion_depth_;
    }
    void give() {
        if (--recursion_depth_ != 0)
            return;
        owner_.store(nullptr, std::memory_order_relaxed);
        pthread_mutex_unlock(&mutex_);
    }

  private:
    pthread_mutex_t mutex_ = PTHREAD_MUTEX_INITIALIZER;
    std::atomic<const void*> owner_ = nullptr;
    unsigned recursion_depth_ = 0; ///< how many times the owner has taken the lock
};

/// Holds a lock while it lives.
class LockGuard {
  public:
    explicit LockGuard(Lock& lock) : lock_(lock) { lock_.take(); }
    ~LockGuard() { lock_.give(); }
    LockGuard(const LockGuard&) = delete;
    LockGuard& operator=(const LockGuard&) = delete;

  private:
    Lock& lock_;
};

/// Holds the lock of the objects that a context shares with others, while it lives.
class SharedObjects {
  public:
    explicit SharedObjects(Context& context);
    ~SharedObjects() { lock_.give(); }
    SharedObjects(const SharedObjects&) = delete;
    SharedObjects& operator=(const SharedObjects&) = delete;

  private:
    Lock& lock_;
};

#else

struct Lock {
    void take() {}
    void give() {}
};

struct LockGuard {
    explicit LockGuard(Lock&) {}
};

struct SharedObjects {
    explicit SharedObjects(Context&) {}
};

#endif

} // namespace spangle::gl
