// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PCN_IS_INSTRUMENTED true
#elif defined(__has_feature)  // clang's word for it
#define PCN_IS_INSTRUMENTED (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#else
#define PCN_IS_INSTRUMENTED false
#endif

namespace pomdp_crowd_nav {

// Whether this is built with AddressSanitizer or ThreadSanitizer, by scripts/sanitize.sh. Nodes are
// then several times slower, and a robot whose decisions or people come late rests, as it should:
// tests do not ask it to keep moving.
constexpr bool kIsInstrumented = PCN_IS_INSTRUMENTED;

}  // namespace pomdp_crowd_nav
