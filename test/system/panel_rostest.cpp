// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <QImage>
#include <algorithm>

#include "fake_planner.h"
#include "panel_rig.h"
#include "pomdp_crowd_nav/rviz_panel/sparkline.h"

namespace pomdp_crowd_nav {
namespace {

class PanelTest : public testing::Test {
 protected:
  PanelTest() : fake_(std::make_unique<FakePlanner>("fake")), rig_("fake") {}

  void SetUp() override {
    ASSERT_TRUE(rig_.waitForText("state_label", "IDLE")) << rig_.text("state_label");
    ASSERT_TRUE(rig_.waitForEnabled("reset_button"));
  }

  bool waitForCall(const std::string& call) {
    return rig_.waitUntil(10.0, [&] { return fake_->wasAsked(call); });
  }

  void setState(std::uint8_t state, const std::string& name, const std::string& cause = "") {
    fake_->setState(state, name, cause);
    ASSERT_TRUE(rig_.waitForText("state_label", name)) << rig_.text("state_label");
  }

  std::unique_ptr<FakePlanner> fake_;
  PanelRig rig_;
};

TEST_F(PanelTest, PausesResumesAndStops) {
  setState(PlannerStatus::DRIVING, "DRIVING");
  EXPECT_FALSE(rig_.isEnabled("start_button"));
  rig_.click("pause_button");
  EXPECT_TRUE(waitForCall("pause"));
  EXPECT_TRUE(rig_.waitForText("message_label", "paused"));
  rig_.click("stop_button");
  EXPECT_TRUE(waitForCall("cancel all"));
  EXPECT_EQ(fake_->callCount(), 2u);
}

TEST_F(PanelTest, StartsWithTheLastGoal) {
  fake_->showGoal(12.0, 34.0);
  rig_.waitUntil(1.0, [] { return false; });
  rig_.click("start_button");
  EXPECT_TRUE(waitForCall("goal map 12 34"));
  EXPECT_TRUE(fake_->wasAsked("resume")) << "a pause that has outlasted its trip";
  EXPECT_TRUE(rig_.waitForText("message_label", "goal (12.0, 34.0) sent"));
}

TEST_F(PanelTest, StartsWithTheGoalOfTheWorldWhereThereWasNone) {
  ros::param::set("/fake/sim_node/world_file",
                  std::string(SOURCE_DIR) + "/config/worlds/scenario_1.yaml");
  ros::param::set("/fake/sim_node/global_frame", "field");
  rig_.click("start_button");
  EXPECT_TRUE(waitForCall("goal field 100 75")) << rig_.text("message_label");
}

TEST_F(PanelTest, SaysWhyAWorldCannotBeRead) {
  ros::param::set("/fake/sim_node/world_file", "/nowhere/world.yaml");
  rig_.click("start_button");
  EXPECT_TRUE(rig_.waitForText("message_label", "/nowhere/world.yaml"));
}

TEST_F(PanelTest, ChoosesAPlannerWhileIdleOnly) {
  ASSERT_TRUE(rig_.waitUntil(
      10.0, [&] { return rig_.find<QComboBox>("planner_choice")->currentText() == "2d_fmm"; }));
  rig_.choose("2d_prm");
  EXPECT_TRUE(waitForCall("planner 2d_prm"));
  EXPECT_TRUE(rig_.waitForText("message_label", "planner 2d_prm"));
  setState(PlannerStatus::DRIVING, "DRIVING");
  EXPECT_FALSE(rig_.isEnabled("planner_choice"));
  EXPECT_EQ(rig_.tooltip("planner_choice"),
            "the planner can be changed only while no trip is under way");
}

TEST_F(PanelTest, ShowsThePlannerThatStaysWhereAnotherIsRefused) {
  fake_->change([](FakePlanner::Asked& asked) { asked.refuses = true; });
  rig_.choose("2d_straight");
  EXPECT_TRUE(rig_.waitForText("message_label", "keeps the planner 2d_fmm"));
  EXPECT_TRUE(rig_.waitUntil(
      5.0, [&] { return rig_.find<QComboBox>("planner_choice")->currentText() == "2d_fmm"; }));
}

TEST_F(PanelTest, ResetsWithSeedAndPeople) {
  rig_.find<QSpinBox>("seed_field")->setValue(77);
  rig_.find<QSpinBox>("people_field")->setValue(250);
  rig_.click("reset_button");
  EXPECT_TRUE(waitForCall("reset 250 77"));
  EXPECT_TRUE(rig_.waitForText("message_label", "reset: simulating a field"));
  fake_->change([](FakePlanner::Asked& asked) { asked.refuses = true; });
  rig_.find<QSpinBox>("people_field")->setValue(-1);
  rig_.click("reset_button");
  EXPECT_TRUE(waitForCall("reset -1 77"));
  EXPECT_TRUE(rig_.waitForText("message_label", "not reset: too many people"));
}

TEST_F(PanelTest, DoesNotWaitForAServiceThatHangs) {
  setState(PlannerStatus::DRIVING, "DRIVING");
  fake_->change([](FakePlanner::Asked& asked) { asked.answers_after = 6.0; });
  const double begin = steadySeconds();
  rig_.click("pause_button");
  EXPECT_LT(steadySeconds() - begin, 1.0) << "the click itself";
  EXPECT_TRUE(waitForCall("pause"));
  EXPECT_FALSE(rig_.isEnabled("pause_button"));
  EXPECT_TRUE(rig_.isEnabled("stop_button"));
  fake_->setState(PlannerStatus::BLOCKED, "BLOCKED");
  EXPECT_TRUE(rig_.waitForText("state_label", "BLOCKED", 2.0)) << "it goes on showing";
  EXPECT_TRUE(rig_.waitForText("message_label", "planner_node does not answer", 5.5));
  EXPECT_TRUE(rig_.waitForEnabled("pause_button"));
}

TEST_F(PanelTest, StopForestallsAStartThatStillWaits) {
  fake_->showGoal(12.0, 34.0);
  rig_.waitUntil(1.0, [] { return false; });
  fake_->change([](FakePlanner::Asked& asked) { asked.answers_after = 2.0; });
  rig_.click("start_button");
  EXPECT_TRUE(waitForCall("resume"));
  ASSERT_TRUE(rig_.waitForEnabled("stop_button"));
  rig_.click("stop_button");
  EXPECT_TRUE(waitForCall("cancel all"));
  rig_.waitUntil(4.0, [] { return false; });
  EXPECT_FALSE(fake_->wasAsked("goal map 12 34"));
}

TEST_F(PanelTest, MissesAPlannerThatGoesAndFindsTheNext) {
  fake_.reset();
  EXPECT_TRUE(rig_.waitForText("state_label", "no planner_node"));
  EXPECT_TRUE(rig_.waitForText("cause_label", "last heard"));
  EXPECT_FALSE(rig_.isEnabled("start_button"));
  EXPECT_TRUE(rig_.waitUntil(10.0, [&] { return !rig_.isEnabled("reset_button"); }));
  EXPECT_EQ(rig_.tooltip("reset_button"), "there is no sim_node: nothing to reset");
  fake_ = std::make_unique<FakePlanner>("fake", false);
  EXPECT_TRUE(rig_.waitForText("state_label", "IDLE", 20.0));
  EXPECT_FALSE(rig_.isEnabled("reset_button")) << "this one has no simulator";
}

TEST_F(PanelTest, TakesOtherNamesAndKeepsThem) {
  const FakePlanner other("other");
  const auto type = [&](const char* text) {
    auto* field = rig_.find<QLineEdit>("namespace_field");
    field->setText(text);
    Q_EMIT field->editingFinished();
  };
  type("no name");
  EXPECT_EQ(rig_.text("message_label"), "the namespace must be a ROS name, got 'no name'");
  type("nobody");
  EXPECT_TRUE(rig_.waitForText("state_label", "no planner_node"));
  type("other");
  EXPECT_TRUE(rig_.waitForText("state_label", "IDLE", 20.0));
  rig_.find<QSpinBox>("seed_field")->setValue(5);
  rviz::Config saved;
  rig_.panel().save(saved);
  QString space;
  int seed = 0;
  EXPECT_TRUE(saved.mapGetString("Namespace", &space));
  EXPECT_TRUE(saved.mapGetInt("Seed", &seed));
  EXPECT_EQ(space, "other");
  EXPECT_EQ(seed, 5);
}

// Pixels of exactly that colour in a widget's part of the picture.
int count(const QImage& picture, const QWidget& widget, const QWidget& panel, QRgb colour) {
  const QRect area(widget.mapTo(&panel, QPoint(0, 0)), widget.size());
  int found = 0;
  for (int y = area.top(); y <= area.bottom(); ++y) {
    for (int x = area.left(); x <= area.right(); ++x) {
      if (picture.rect().contains(x, y) && picture.pixel(x, y) == colour) ++found;
    }
  }
  return found;
}

int countDark(const QImage& picture, const QWidget& widget, const QWidget& panel) {
  const QRect area(widget.mapTo(&panel, QPoint(0, 0)), widget.size());
  int found = 0;
  for (int y = area.top(); y <= area.bottom(); ++y) {
    for (int x = area.left(); x <= area.right(); ++x) {
      if (picture.rect().contains(x, y) && qGray(picture.pixel(x, y)) < 110) ++found;
    }
  }
  return found;
}

class PanelPictureTest : public PanelTest {
 protected:
  // One decision of ten is late.
  void decide(int decisions) {
    for (int i = 1; i <= decisions; ++i) {
      fake_->change([&](FakePlanner::Asked& asked) {
        asked.status.decisions = static_cast<unsigned>(i);
        asked.status.cycle_time = i % 10 == 0 ? 0.48 : 0.35;
      });
      rig_.waitUntil(0.12, [] { return false; });
    }
  }

  QImage grab() {
    rig_.waitUntil(0.3, [] { return false; });
    const QString file = QString(RESULTS_DIR) + "/panel.png";
    EXPECT_TRUE(rig_.panel().grab().save(file));
    return QImage(file).convertToFormat(QImage::Format_RGB32);
  }
};

TEST_F(PanelPictureTest, HasTextsBarsAndTheDeadline) {
  setState(PlannerStatus::DRIVING, "DRIVING");
  fake_->change([](FakePlanner::Asked& asked) { asked.status.trials = 4321; });
  decide(40);
  ASSERT_TRUE(rig_.waitForText("decision_label", "of 0.40 s, 4321 trials"));
  const QImage picture = grab();
  ASSERT_FALSE(picture.isNull());
  const QWidget& panel = rig_.panel();
  const auto& bars = *rig_.find<QWidget>("cycle_sparkline");
  const int in_time = count(picture, bars, panel, Sparkline::kInTime);
  const int late = count(picture, bars, panel, Sparkline::kLate);
  EXPECT_GT(bars.width(), 200);
  EXPECT_GT(in_time, 1000);
  EXPECT_GT(late, 100);
  EXPECT_LT(late, in_time / 4);
  EXPECT_GT(count(picture, bars, panel, Sparkline::kDeadline), 50);
  const auto& state = *rig_.find<QWidget>("state_label");
  EXPECT_GT(count(picture, state, panel, 0xff2e7d32), state.width() * state.height() / 2);
  for (const char* label : {"decision_label", "late_label", "odometry_label", "people_label"}) {
    EXPECT_GT(countDark(picture, *rig_.find<QWidget>(label), panel), 20) << label;
  }
}

TEST_F(PanelPictureTest, LongTextsWrapInsteadOfWideningTheDock) {
  const std::string cause =
      "no progress for 21 s: odometry is refused: the transform to the global frame is too old";
  setState(PlannerStatus::BLOCKED, "BLOCKED", cause);
  ASSERT_TRUE(rig_.waitForText("cause_label", cause));
  rig_.panel().resize(300, 480);
  rig_.waitUntil(0.3, [] { return false; });
  EXPECT_LE(rig_.panel().minimumSizeHint().width(), 300);
  const auto& label = *rig_.find<QLabel>("cause_label");
  EXPECT_LE(label.width(), 300);
  EXPECT_GE(label.height(), 2 * label.fontMetrics().height());
}

TEST(PanelConfigs, OfTheShippedViewsNameThePanel) {
  for (const char* name : {"navigation", "street"}) {
    const YAML::Node view =
        YAML::LoadFile(std::string(SOURCE_DIR) + "/rviz/" + name + ".rviz")["Panels"];
    const bool has_panel = std::any_of(view.begin(), view.end(), [](const YAML::Node& panel) {
      return panel["Class"].as<std::string>() == "pomdp_crowd_nav/NavigationPanel";
    });
    EXPECT_TRUE(has_panel) << name;
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  return pomdp_crowd_nav::runPanelTests(argc, argv, "panel_rostest");
}
