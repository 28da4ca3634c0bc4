// SPDX-License-Identifier: BSD-3-Clause
// Output files and digests.

#include "io/files/atomic_file.h"
#include "io/files/folder_lock.h"
#include "io/files/scratch_folder.h"
#include "io/files/sha256.h"
#include "tests/support/temp_folder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <span>
#include <string>

namespace ridgeline::io {
namespace {

TEST(AtomicFile, AppearsOnCommitOnly) {
  const TempFolder folder;
  const std::string path = folder.write("a.txt", "old");
  {
    AtomicFile file(path);
    file.stream() << "new";
    EXPECT_EQ(folder.read("a.txt"), "old");
  }
  EXPECT_EQ(folder.read("a.txt"), "old");
  EXPECT_EQ(folder.num_files(), 1U);
  write_file(folder.file("a.txt"), std::string("n\0w", 3));
  EXPECT_EQ(folder.read("a.txt"), std::string("n\0w", 3));
  EXPECT_EQ(folder.num_files(), 1U);
}

TEST(AtomicFile, MakesMissingFoldersAndKeepsTheEnding) {
  const TempFolder folder;
  AtomicFile file(folder.file("x/y/a.gpkg"));
  EXPECT_TRUE(file.temporary_path().ends_with(".gpkg"));
  file.commit();
  EXPECT_EQ(folder.read("x/y/a.gpkg"), "");
}

TEST(AtomicFile, ReplacesALinkAndLeavesWhatItNames) {
  const TempFolder folder;
  const std::string mine = folder.write("mine.txt", "mine");
  std::filesystem::create_symlink(mine, folder.file("link.txt"));
  write_file(folder.file("link.txt"), "new");
  EXPECT_EQ(folder.read("mine.txt"), "mine");
  EXPECT_EQ(folder.read("link.txt"), "new");
  EXPECT_FALSE(std::filesystem::is_symlink(folder.file("link.txt")));
}

TEST(AtomicFile, LeavesNoFolderWithoutACommit) {
  const TempFolder folder;
  { const AtomicFile file(folder.file("x/y/a.txt")); }
  EXPECT_FALSE(std::filesystem::exists(folder.file("x")));
}

TEST(IsLeftByDeadProcess, KnowsTheNamesOfItsOwnFilesAlone) {
  // above the largest process number of Linux, 2^22
  EXPECT_TRUE(is_left_by_dead_process(".run.4194305.0.tmp.json"));
  EXPECT_TRUE(is_left_by_dead_process(".run.4194305.12.tmp"));
  for (const char* name : {"run.4194305.0.tmp.json", ".run.0.tmp.json", ".run.x.0.tmp.json",
                           ".run.4194305.0.json", ".4194305.tmp"}) {
    EXPECT_FALSE(is_left_by_dead_process(name)) << name;
  }
  EXPECT_FALSE(is_left_by_dead_process(".run." + std::to_string(getpid()) + ".0.tmp.json"));
}

TEST(FolderLock, IsSharedWithinAProcessAndGoneAtItsEnd) {
  const TempFolder folder;
  (void)folder.write("a.txt", "");
  const std::string left = folder.write(".a.4194305.0.tmp.txt", "half");
  {
    const auto lock = FolderLock::of(folder.file(""));
    EXPECT_EQ(lock, FolderLock::of(folder.file(".")));
    EXPECT_TRUE(std::filesystem::exists(folder.file(".ridgeline.lock")));
    EXPECT_FALSE(std::filesystem::exists(left));
  }
  EXPECT_EQ(folder.num_files(), 1U);
}

TEST(FolderLock, RemovesTheScratchFolderOfAKilledProcess) {
  const TempFolder folder;
  const std::string target = folder.file("patch/lines.gpkg");
  const pid_t child = fork();
  if (child == 0) {
    const ScratchFolder scratch(target);
    write_file(scratch.draft(), "half");
    _exit(0);  // without destructors, as a killed process
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  EXPECT_FALSE(std::filesystem::is_empty(folder.file("patch")));
  const auto lock = FolderLock::of(folder.file(""));
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("patch")));
}

TEST(FolderLock, IsRefusedToAnotherProcess) {
  const TempFolder folder;
  const auto lock = FolderLock::of(folder.file(""));
  const int other = open(folder.file(".ridgeline.lock").c_str(), O_RDWR);
  ASSERT_GE(other, 0);
  EXPECT_NE(flock(other, LOCK_EX | LOCK_NB), 0);  // not the description that holds the lock
  EXPECT_EQ(errno, EWOULDBLOCK);
  close(other);
}

TEST(AtomicFile, NamesThePathThatCannotBeWritten) {
  const TempFolder folder;
  const std::string a_file = folder.write("a.txt", "");
  EXPECT_THAT(io_error_of([&] { write_file(a_file + "/b.txt", ""); }),
              testing::HasSubstr("a.txt: the folder cannot be created"));
  EXPECT_THAT(io_error_of([&] { write_file(folder.file(""), ""); }),
              testing::HasSubstr("is a folder"));
}

// FIPS 180-4 examples (NIST, Cryptographic Standards and Guidelines: SHA-256).
TEST(Sha256, GivesThePublishedDigests) {
  const auto digest = [](const std::string& text) {
    Sha256 hash;
    hash.update(std::as_bytes(std::span(text)));
    return hash.hex_digest();
  };
  EXPECT_EQ(digest(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(digest("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(digest(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnThePieces) {
  const std::string text(300, 'x');
  const auto bytes = std::as_bytes(std::span(text));
  Sha256 whole;
  whole.update(bytes);
  const std::string expected = whole.hex_digest();
  for (std::size_t piece = 1; piece < 130; ++piece) {
    Sha256 hash;
    for (std::size_t i = 0; i < bytes.size(); i += piece) {
      hash.update(bytes.subspan(i, std::min(piece, bytes.size() - i)));
    }
    EXPECT_EQ(hash.hex_digest(), expected) << piece;
  }
}

TEST(Sha256OfFile, ReadsTheFile) {
  const TempFolder folder;
  EXPECT_EQ(sha256_of_file(folder.write("abc", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_NE(io_error_of([&] { sha256_of_file(folder.file("none")); }), "");
}

}  // namespace
}  // namespace ridgeline::io
