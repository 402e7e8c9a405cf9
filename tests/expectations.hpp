#pragma once

#include <gtest/gtest.h>

#include <iterator>
#include <string>

namespace rift {

/// How long a test waits for what it expects of another process [s].
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int patience_s = 200;
#else
inline constexpr int patience_s = 20;
#endif

/// Whether `text` contains `part`, as in EXPECT_TRUE(contains(ran.err, "must lie in")).
inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "no \"" << part << "\" in:\n" << text;
}

/// The range itself, for a loop that holds a test's expectations, as in
/// `for (const Claim& claim : not_empty(claims()))`: the test fails where the loop would try nothing.
template <class Range>
Range not_empty(Range&& range, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (std::empty(range)) ADD_FAILURE_AT(file, line) << "this loop has nothing to try";
  return static_cast<Range&&>(range);
}

}  // namespace rift
