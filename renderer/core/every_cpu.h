// SPDX-License-Identifier: Apache-2.0
#pragma once

// A function with this attribute exists once for every instruction set named, and the loader picks.
// ThreadSanitizer cannot start a program that does so: its runtime is not up when the loader asks.
#if defined(__SANITIZE_THREAD__)
#define BOUGUER_FOR_EVERY_CPU
#else
#define BOUGUER_FOR_EVERY_CPU [[gnu::target_clones("avx512f", "avx2", "default")]]
#endif
