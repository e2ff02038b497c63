// SPDX-License-Identifier: Apache-2.0
// Tells ThreadSanitizer of an order that it cannot see, because the library that keeps it is not
// instrumented. Without the sanitizer there is nothing.
#pragma once

#if defined(__SANITIZE_THREAD__)
#define BOUGUER_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define BOUGUER_THREAD_SANITIZER 1
#endif
#endif

#ifdef BOUGUER_THREAD_SANITIZER
extern "C" {
void __tsan_acquire(void* address);  // NOLINT: the sanitizer's name
void __tsan_release(void* address);  // NOLINT: likewise
}
#endif

namespace bouguer::renderer {

/// What this thread did until now comes before happens_after() of the same `token` in another.
inline void happens_before([[maybe_unused]] const void* token) {
#ifdef BOUGUER_THREAD_SANITIZER
    __tsan_release(const_cast<void*>(token));  // an address only
#endif
}

inline void happens_after([[maybe_unused]] const void* token) {
#ifdef BOUGUER_THREAD_SANITIZER
    __tsan_acquire(const_cast<void*>(token));  // an address only
#endif
}

}  // namespace bouguer::renderer
