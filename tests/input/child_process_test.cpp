#include "input/child_process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace secular {
namespace {

namespace fs = std::filesystem;

ProcessEnd shell(const std::string& command) {
  return run_process({.arguments = {"/bin/sh", "-c", command}});
}

TEST(ChildProcess, IsJudgedByHowItEnds) {
  const ProcessEnd three = shell("echo said; echo complained >&2; exit 3");
  EXPECT_EQ(three.status, 3);
  EXPECT_EQ(three.output, "said\ncomplained\n");
  EXPECT_EQ(shell("kill -9 $$").status, -1);
  const ProcessEnd missing = run_process({.arguments = {"/nonexistent/program"}});
  EXPECT_EQ(missing.status, -1);
  EXPECT_EQ(missing.refused, ENOENT);
  EXPECT_EQ(run_process({.arguments = {"true"}}).status, 0);
}

TEST(ChildProcess, SeesWhatItIsGivenAndNoShell) {
  const ProcessEnd cat = run_process({.arguments = {"cat"}, .input = "line\n"});
  EXPECT_EQ(cat.output, "line\n");
  EXPECT_EQ(run_process({.arguments = {"cat"}}).output, "");
  EXPECT_EQ(run_process({.arguments = {"printf", "%s", "$HOME; `x` \"y\""}}).output, "$HOME; `x` \"y\"");
  ::setenv("SECULAR_TEST_VARIABLE", "old", 1);
  const std::vector<std::string> show = {"/bin/sh", "-c", "echo $SECULAR_TEST_VARIABLE"};
  EXPECT_EQ(run_process({.arguments = show}).output, "old\n");
  EXPECT_EQ(run_process({.arguments = show, .hidden = {"SECULAR_TEST_"}}).output, "\n");
  EXPECT_EQ(run_process({.arguments = show, .hidden = {"SECULAR_TEST_"}, .settings = {"SECULAR_TEST_VARIABLE=new"}})
                .output,
            "new\n");
  ::unsetenv("SECULAR_TEST_VARIABLE");
}

TEST(ChildProcess, LongOutputBlocksNobody) {
  const ProcessEnd both =
      run_process({.arguments = {"/bin/sh", "-c", "head -c 3000000 /dev/zero; head -c 2000000 /dev/zero >&2"},
                   .errors_apart = true});
  EXPECT_EQ(both.output.size(), 3000000U);
  EXPECT_EQ(both.errors.size(), 2000000U);
}

TEST(ChildProcess, ALogHoldsWhatItSaid) {
  const fs::path log = fs::path(testing::TempDir()) / ("secular_log_" + std::to_string(::getpid()));
  const ProcessEnd ended =
      run_process({.arguments = {"/bin/sh", "-c", "echo said; echo complained >&2"}, .log = log, .limit_s = 20});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.output, "");
  std::ifstream stream(log);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "said\ncomplained\n");
  fs::remove(log);
}

// An interrupt from the terminal goes to a group of processes.
TEST(ChildProcess, StaysInTheGroupUnlessItsTimeIsLimited) {
  const std::vector<std::string> group = {"/bin/sh", "-c", "cut -d ' ' -f 5 /proc/self/stat"};
  const std::string own = std::to_string(::getpgrp()) + "\n";
  EXPECT_EQ(run_process({.arguments = group}).output, own);
  EXPECT_NE(run_process({.arguments = group, .limit_s = 20}).output, own);
}

TEST(ChildProcess, OutOfTimeEndsWithAllThatItHasStarted) {
  const fs::path trace = fs::path(testing::TempDir()) / ("secular_trace_" + std::to_string(::getpid()));
  const ProcessEnd slow = run_process(
      {.arguments = {"/bin/sh", "-c", "(sleep 0.3; touch " + trace.string() + ") & sleep 30"}, .limit_s = 0.05});
  EXPECT_TRUE(slow.out_of_time);
  EXPECT_EQ(slow.status, -1);
  EXPECT_LT(slow.seconds, 20);
  ::usleep(500000);
  EXPECT_FALSE(fs::exists(trace));
}

}  // namespace
}  // namespace secular
