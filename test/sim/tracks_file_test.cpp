// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/tracks_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "temporary_file.h"

namespace pomdp_crowd_nav {
namespace {

const std::string kHeader = "time_s,ped_id,x_m,y_m\n";

// The error without the path of the file.
std::string errorFor(const std::string& text) {
  const TemporaryFile file("tracks.csv", text);
  const std::string message = messageOf([&] { readTracksFile(file.path()); });
  EXPECT_EQ(message.compare(0, file.path().size(), file.path()), 0) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  return message.substr(file.path().size());
}

TEST(TracksFile, ReadsRows) {
  const TemporaryFile file("tracks.csv", kHeader + "0.00,1,1.5,-2\r\n 0.40, 1 ,1.9,-2.1\n\n");
  const std::vector<TrackSample> samples = readTracksFile(file.path());
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].id, 1);
  EXPECT_EQ(samples[0].position, Point(1.5, -2.0));
  EXPECT_DOUBLE_EQ(samples[1].time, 0.4);
  EXPECT_EQ(samples[1].position, Point(1.9, -2.1));
}

TEST(TracksFile, NamesLineColumnAndValue) {
  EXPECT_EQ(errorFor(kHeader + "0,1,2,3\n0.4,1,abc,3\n"),
            ":3: column x_m: expected a number, got 'abc'");
  EXPECT_EQ(errorFor(kHeader + "0,1,2,nan\n"), ":2: column y_m: expected a number, got 'nan'");
  EXPECT_EQ(errorFor(kHeader + "0,1,inf,3\n"), ":2: column x_m: expected a number, got 'inf'");
  EXPECT_EQ(errorFor(kHeader + "1e999,1,2,3\n"),
            ":2: column time_s: expected a number, got '1e999'");
  EXPECT_EQ(errorFor(kHeader + "0,1.5,2,3\n"), ":2: column ped_id: expected an integer, got '1.5'");
  EXPECT_EQ(errorFor(kHeader + "0,1,,3\n"), ":2: column x_m: expected a number, got ''");
}

TEST(TracksFile, RejectsWhatIsOutOfThisWorld) {
  EXPECT_EQ(errorFor(kHeader + "0,1,-1e308,3\n"),
            ":2: column x_m: expected a number within +-1e+06, got '-1e308'");
  EXPECT_EQ(errorFor(kHeader + "1e11,1,2,3\n"),
            ":2: column time_s: expected a number within +-1e+10, got '1e11'");
  const TemporaryFile file("tracks.csv", kHeader + "1795768829.5,1,1e6,-1e6\n");
  EXPECT_EQ(readTracksFile(file.path()).size(), 1u);
}

TEST(TracksFile, RejectsRowsThatDoNotFit) {
  EXPECT_EQ(errorFor(kHeader + "0,1,2\n"), ":2: expected 4 columns, got 3");
  EXPECT_EQ(errorFor(kHeader + "0,1,2,3,4\n"), ":2: expected 4 columns, got 5");
  EXPECT_EQ(errorFor(kHeader + "0.4,1,2,3\n0.0,1,2,3\n"),
            ":3: column time_s: expected rows in order of time, got '0.0'");
  EXPECT_EQ(errorFor(kHeader + "0.4,1,2,3\n0.4,2,2,3\n0.4,1,5,5\n"),
            ":4: person 1 is given twice at time 0.4");
}

TEST(TracksFile, NeedsAHeaderAndRows) {
  EXPECT_EQ(errorFor("0,1,2,3\n"),
            ":1: expected the header 'time_s,ped_id,x_m,y_m', got '0,1,2,3'");
  EXPECT_EQ(errorFor(""), ":1: expected the header 'time_s,ped_id,x_m,y_m', got ''");
  EXPECT_EQ(errorFor(kHeader), ": no rows");
}

TEST(TracksFile, NamesAFileThatCannotBeRead) {
  EXPECT_EQ(messageOf([] { readTracksFile("/nowhere/tracks.csv"); }),
            "/nowhere/tracks.csv: the file cannot be read");
  const std::string here = std::filesystem::current_path().string();
  EXPECT_EQ(messageOf([] { readTracksFile("nowhere.csv"); }),
            "nowhere.csv: the file cannot be read (looked for in " + here + ")");
  EXPECT_EQ(messageOf([] { readTracksFile(SOURCE_DIR); }), SOURCE_DIR ": the file cannot be read");
}

}  // namespace
}  // namespace pomdp_crowd_nav
