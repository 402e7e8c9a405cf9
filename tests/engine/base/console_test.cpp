#include "engine/base/console.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace rift::base {
namespace {

TEST(Message, EscapesTheTextsAmongItsArguments) {
  testing::internal::CaptureStderr();
  const std::string name = "r\xe9s\x1b[2J\nrift: all is well";
  message("rift {}: {} of {:.1f} in {}\n", "run", 3, 0.25, name);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "rift run: 3 of 0.2 in r\\xe9s\\x1b[2J\\x0arift: all is well\n");
}

TEST(Print, EscapesTheTextsAmongItsArgumentsAndLeavesATextAlone) {
  testing::internal::CaptureStdout();
  print("{:<5}{}/\n", "in", std::string("a\x1b"));
  print_text("\x1b[1mhead\x1b[0m\n");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "in   a\\x1b/\n\x1b[1mhead\x1b[0m\n");
}

TEST(PrintPath, IsByteByByteForOtherPrograms) {
  testing::internal::CaptureStdout();
  print_path("r\xe9s/a\nb");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "r\xe9s/a\nb\n");
}

/// In a process of its own, whose exit code is what `work` returns.
template <typename Work>
int exit_code_of(const Work& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void become(int descriptor, const char* path) { dup2(open(path, O_WRONLY), descriptor); }

TEST(Message, IsLostWhereStandardErrorCannotBeWritten) {
  EXPECT_EQ(exit_code_of([] {
              become(STDERR_FILENO, "/dev/full");
              message("{}\n", "lost");
              close(STDERR_FILENO);
              message("{}\n", "lost too");
              return 7;
            }),
            7);
}

TEST(Message, IsLostWhereNobodyReadsThePipe) {
  EXPECT_EQ(exit_code_of([] {
              secure_standard_streams();
              int ends[2];
              if (pipe(ends) != 0 || dup2(ends[1], STDERR_FILENO) < 0) return 1;
              close(ends[0]);
              message("{}\n", "lost");
              return 7;
            }),
            7);
}

TEST(Message, IsLostWhereAReaderStandsStill) {
  EXPECT_EQ(exit_code_of([] {
              int ends[2];
              if (pipe(ends) != 0 || dup2(ends[1], STDERR_FILENO) < 0) return 1;
              alarm(20);
              for (int k = 0; k < 100; ++k) message_text(std::string(4096, '.'));  // a pipe holds 64 KiB
              return 7;
            }),
            7);
}

TEST(Print, KeepsWhyStandardOutputCouldNotBeWritten) {
  EXPECT_EQ(exit_code_of([] {
              if (printing_failure() != 0) return 1;
              become(STDOUT_FILENO, "/dev/full");
              print("{}\n", "lost");
              return printing_failure();
            }),
            ENOSPC);
}

TEST(StandardStreams, ThatAreClosedAreNeverAFileOfOurs) {
  EXPECT_EQ(exit_code_of([] {
              for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) close(descriptor);
              secure_standard_streams();
              return open("/dev/zero", O_RDONLY) > STDERR_FILENO ? 7 : 1;
            }),
            7);
}

TEST(StandardStreams, OfATerminalsBackgroundStopNoProcess) {
  EXPECT_EQ(exit_code_of([] {
              secure_standard_streams();
              raise(SIGTTOU);
              raise(SIGTTIN);
              return 7;
            }),
            7);
}

TEST(InForeground, IsNoPipe) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  EXPECT_FALSE(in_foreground(ends[0]));
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace rift::base
