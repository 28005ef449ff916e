// Blind sets over MPI: the same bytes as one process, whatever ranks are slow or end. Skipped where there is no
// MPI.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <map>
#include <sstream>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::text_of;

class ManyProcesses : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(mpi_) || std::system("mpirun --version > /dev/null 2>&1") != 0)
      GTEST_SKIP() << "there is no " << mpi_ << " or no mpirun: libopenmpi-dev was not installed";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // A shell at work in the folder, which knows the program as $S, that of many processes on N ranks as `ranks N`.
  // What Open MPI itself leaves unfreed is not looked for. Returns the exit status.
  int shell(const std::string& script) const {
    std::ofstream(folder_ / "script.sh")
        << "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1\n"
           "ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0; export ASAN_OPTIONS\n"
           "ranks() { n=$1; shift; exec mpirun --oversubscribe -n $n " +
               mpi_ + " \"$@\"; }\n" + script;
    const int ended = std::system(("cd " + folder_.string() + " && S=" + testing_support::program() +
                                   " timeout 300 bash script.sh > shell.txt 2>&1 < /dev/null")
                                      .c_str());
    return WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  }

  // Sealed sets of 12 campaigns, and in place of the program that is checked one that is slow on one rank and says
  // where it ran.
  void write_sets(std::initializer_list<const char*> sets) const {
    for (const std::string set : sets) {
      for (int i = 1; i <= 12; ++i) fs::create_directories(folder_ / set / fmt::format("case_{:04}", i));
      std::ofstream(folder_ / set / "set.json") << R"({"schema": 1, "seed": 1, "set": "short", "cases": 12})";
      std::ofstream(folder_ / set / "labels.sha256") << "of labels that nobody opens";
    }
    std::ofstream(folder_ / "checked.sh")
        << "#!/bin/sh\ncase \"$*\" in *--help*) echo '--model --threads'; exit 0;; "
           "esac\nrank=$OMPI_COMM_WORLD_RANK\n"
           "test \"$rank\" = 1 && sleep ${SLOW:-0}\nsleep 0.05\necho $rank >> ranks.txt\ncase $2 in */case_0007/*) "
           "echo "
           "'no such mode' >&2; exit 2;; esac\nmkdir $6 && echo \"$2\" | sed 's,^[^/]*/,,' > $6/diagnosis.json\n";
    fs::permissions(folder_ / "checked.sh", fs::perms::owner_all);
  }

  // Contents of all files by path, but for times.
  std::map<std::string, std::string> files_of(const std::string& set) const {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_ / set))
      if (entry.is_regular_file() && entry.path().filename() != "run.json")
        files[fs::relative(entry.path(), folder_ / set).string()] = text_of(entry.path());
    return files;
  }

  const std::string mpi_ = fs::path(testing_support::program()).replace_filename("secular-mpi").string();
  const fs::path folder_ = testing_support::process_folder() / "many_processes";
};

TEST_F(ManyProcesses, MakeTheSameSetAsOne) {
  const std::string generate = " blind generate --records one_decay --campaigns 4 --seed 8 --threads 1 -o ";
  ASSERT_EQ(shell("$S" + generate + "one\n"), 0) << text_of(folder_ / "shell.txt");
  ASSERT_EQ(shell("ranks 3" + generate + "three\n"), 0) << text_of(folder_ / "shell.txt");
  EXPECT_EQ(files_of("one").count("labels.json"), 1U);
  EXPECT_EQ(files_of("one"), files_of("three"));
}

TEST_F(ManyProcesses, GiveASlowRankLess) {
  write_sets({"one", "five"});
  const std::string run = " --program ./checked.sh > ";
  ASSERT_EQ(shell("$S blind run one --threads 2" + run + "one.txt\n"), 0);
  fs::remove(folder_ / "ranks.txt");
  ASSERT_EQ(shell("export SLOW=1\nranks 5 blind run five" + run + "five.txt\n"), 0)
      << text_of(folder_ / "shell.txt");
  EXPECT_EQ(files_of("one"), files_of("five"));
  EXPECT_EQ(text_of(folder_ / "one.txt"), text_of(folder_ / "five.txt"));
  EXPECT_NE(text_of(folder_ / "five.txt").find("campaign 0007: exit status 2: no such mode"), std::string::npos);
  std::map<std::string, int> done;
  std::istringstream ranks(text_of(folder_ / "ranks.txt"));
  for (std::string rank; ranks >> rank;) ++done[rank];
  EXPECT_EQ(done.size(), 4U);  // rank 0 hands out
  EXPECT_EQ(done.count("0"), 0U);
  for (const char* const rank : {"2", "3", "4"}) EXPECT_LT(done["1"], done[rank]) << rank;
}

// A rank is killed in the middle: others end with what they have started, what is done is kept, and the same
// command does the rest.
TEST_F(ManyProcesses, GoOnAfterARankWasKilled) {
  write_sets({"one", "three"});
  ASSERT_EQ(shell("$S blind run one --program ./checked.sh > one.txt\n"), 0);
  EXPECT_NE(
      shell("export SLOW=7.8125\n(ranks 3 blind run three --program ./checked.sh) & p=$!\nfor i in $(seq 400); "
            "do test $(ls three/*/diagnosis/diagnosis.json 2> /dev/null | wc -l) -ge 3 && break; sleep 0.02; "
            "done\nfor w in $(pgrep -P $p); do grep -qz '^OMPI_COMM_WORLD_RANK=2$' /proc/$w/environ && kill -KILL "
            "$w; done\nwait $p\na=$?\nsleep 0.7\npgrep -cf '^sleep 7.8125' > left.txt\nexit $a\n"),
      0);
  EXPECT_EQ(text_of(folder_ / "left.txt"), "0\n");
  EXPECT_LT(files_of("three").size(), files_of("one").size());
  ASSERT_EQ(shell("ranks 3 blind run three --program ./checked.sh > three.txt\n"), 0);
  EXPECT_EQ(files_of("one"), files_of("three"));
  EXPECT_EQ(text_of(folder_ / "three.txt").find("12 campaigns, 0 diagnosed before"), std::string::npos);
}

TEST_F(ManyProcesses, RefuseWhatOneProcessRefuses) {
  write_sets({"set"});
  std::ofstream(folder_ / "checked.sh") << "#!/bin/sh\necho nothing\n";
  EXPECT_EQ(shell("ranks 3 blind run set --program ./checked.sh\n"), 2);
  EXPECT_NE(text_of(folder_ / "shell.txt").find("has no command 'diagnose'"), std::string::npos)
      << text_of(folder_ / "shell.txt");
  EXPECT_EQ(shell("ranks 2 blind run nowhere\n"), 2);
}

}  // namespace
}  // namespace secular
