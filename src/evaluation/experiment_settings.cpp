// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/experiment_settings.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "pomdp_crowd_nav/evaluation/durable_file.h"
#include "pomdp_crowd_nav/params/file_errors.h"

namespace pomdp_crowd_nav {
namespace {

using Json = nlohmann::json;

Json toJson(const ExperimentSettings& settings) {
  const ExperimentPlan& plan = settings.plan;
  Json json;
  json["version"] = settings.version;
  json["plan"] = {{"worlds", plan.worlds},
                  {"pedestrians", plan.pedestrians},
                  {"planners", plan.planners},
                  {"runs", plan.runs},
                  {"seed", plan.first_seed}};
  json["max_trials"] = settings.max_trials;
  json["search_time"] = settings.search_time;
  json["tracks"] = settings.tracks;
  json["set"] = settings.replaced;
  for (const auto& [name, world] : settings.worlds) {
    json["worlds"][name] = {{"profile", world.profile},
                            {"vehicle", world.vehicle},
                            {"parameters", world.parameters},
                            {"world", world.world},
                            {"recording", world.recording}};
  }
  return json;
}

ExperimentSettings fromJson(const Json& json) {
  ExperimentSettings settings;
  settings.version = json.value("version", "");
  const Json& plan = json.at("plan");
  plan.at("worlds").get_to(settings.plan.worlds);
  plan.at("pedestrians").get_to(settings.plan.pedestrians);
  plan.at("planners").get_to(settings.plan.planners);
  plan.at("runs").get_to(settings.plan.runs);
  plan.at("seed").get_to(settings.plan.first_seed);
  json.at("max_trials").get_to(settings.max_trials);
  json.at("search_time").get_to(settings.search_time);
  json.at("tracks").get_to(settings.tracks);
  json.at("set").get_to(settings.replaced);
  for (const auto& [name, item] : json.at("worlds").items()) {
    ExperimentSettings::WorldSettings& world = settings.worlds[name];
    item.at("profile").get_to(world.profile);
    item.at("vehicle").get_to(world.vehicle);
    item.at("parameters").get_to(world.parameters);
    item.at("world").get_to(world.world);
    world.recording = item.value("recording", "");
  }
  return settings;
}

Json read(const std::string& path) {
  std::ifstream file(path);
  file.peek();  // fails on a directory
  if (!file.is_open() || file.bad()) throw std::runtime_error(cannotBeRead(path));
  const Json json = Json::parse(file, nullptr, false);
  if (json.is_discarded()) throw std::runtime_error(path + ": expected a json document");
  return json;
}

std::string textOf(const Json& flat, const std::string& key) {
  const auto value = flat.find(key);
  return value == flat.end() ? "missing" : value->dump();
}

// A json pointer without its escapes.
std::string readable(std::string pointer) {
  for (size_t at = pointer.find("~1"); at != std::string::npos; at = pointer.find("~1", at)) {
    pointer.replace(at, 2, "/");
  }
  return pointer.substr(1);
}

}  // namespace

// Size and FNV-1a.
std::string fingerprintOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  std::uint64_t size = 0;
  for (char c = 0; file.get(c); ++size) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  }
  if (!file.eof()) throw std::runtime_error(cannotBeRead(path));
  return fmt::format("{} bytes, {:016x}", size, hash);
}

std::string settingsPath(const std::string& results_path) {
  return results_path + ".settings.json";
}

void writeSettings(const std::string& path, const ExperimentSettings& settings) {
  replaceFile(path, toJson(settings).dump(2) + "\n");
}

ExperimentSettings readSettings(const std::string& path) {
  try {
    return fromJson(read(path));
  } catch (const Json::exception& error) {
    const std::string text = error.what();  // begins with [json.exception...]
    throw std::runtime_error(fmt::format("{}: {}", path, text.substr(text.find("] ") + 2)));
  }
}

void requireSameSettings(const std::string& path, const ExperimentSettings& settings) {
  // What replaces parameters shows in them.
  Json there = read(path);
  Json here = toJson(settings);
  there.erase("set");
  here.erase("set");
  there = there.flatten();
  here = here.flatten();
  const std::string version = textOf(there, "/version");
  if (version != textOf(here, "/version")) {
    throw std::runtime_error(fmt::format(
        "{}: the version of the program was {} and is {} now; go on with the program that began",
        path, version, textOf(here, "/version")));
  }
  Json all = there;
  all.update(here);
  for (const auto& [key, value] : all.items()) {
    const std::string before = textOf(there, key);
    const std::string now = textOf(here, key);
    if (before == now) continue;
    throw std::runtime_error(
        fmt::format("{}: {} was {} and is {} now; other settings need another --output", path,
                    readable(key), before, now));
  }
}

}  // namespace pomdp_crowd_nav
