// SPDX-License-Identifier: BSD-3-Clause
//
// The panel without its widgets, for panel_nodes_test.py: prints what it shows whenever that
// changes, and presses the buttons and chooses the planners that it reads from standard input.
#include <ros/ros.h>

#include <chrono>
#include <iostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "pomdp_crowd_nav/ros/guarded.h"
#include "pomdp_crowd_nav/ros/panel/panel_session.h"

namespace pomdp_crowd_nav {
namespace {

using Words = Guarded<std::vector<std::string>>;

void readWords(Words& words) {
  std::string word;
  while (std::cin >> word) {
    words.with([&](auto& list) { list.push_back(word); });
  }
}

void press(PanelSession& session, const std::string& word) {
  if (word == "start") return session.start();
  if (word == "pause") return session.pause();
  if (word == "stop") return session.stop();
  if (word == "reset") return session.reset({8, 5});
  session.choosePlanner(word);
}

void show(const PanelPicture& picture, std::string& shown) {
  const std::string state = picture.texts.state;
  const std::string line = (state.rfind("silent", 0) == 0 ? "silent" : state) + " | " +
                           picture.planner + " | " + picture.message +
                           (picture.controls.reset.is_enabled ? " | reset is possible" : "");
  if (line != shown) std::cout << line << std::endl;
  shown = line;
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  using namespace pomdp_crowd_nav;
  ros::init(argc, argv, "panel_probe");
  const ros::NodeHandle node;
  Words words{std::vector<std::string>()};
  std::thread(readWords, std::ref(words)).detach();
  PanelSession session{PanelNames()};
  std::string shown;
  while (ros::ok()) {
    const auto begin = std::chrono::steady_clock::now();
    session.tick();
    show(session.picture(), shown);
    for (const std::string& word :
         words.with([](auto& list) { return std::exchange(list, std::vector<std::string>()); })) {
      press(session, word);
    }
    const auto duration = std::chrono::steady_clock::now() - begin;
    if (duration > std::chrono::seconds(2)) std::cout << "was made to wait" << std::endl;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return 0;
}
