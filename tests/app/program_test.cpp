// The program as people run it: exit codes, files, what it prints.

#include "run_program.hpp"
#include "scenes.hpp"
#include "scree/run/restart.hpp"
#include "scree/run/simulation.hpp"
#include "scree/run/summary.hpp"

#include <scree/io/frame_reader.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

namespace scree::app::testing {
namespace {

namespace fs = std::filesystem;

using Result = scree::testing::ProgramResult;

/// Runs the program with arguments as a shell splits them.
[[nodiscard]] Result scree(const std::string& arguments) {
  return scree::testing::run_program(SCREE_PROGRAM, arguments);
}

/// A directory of its own, empty.
[[nodiscard]] fs::path fresh(const std::string& name) {
  const fs::path folder = fs::path{::testing::TempDir()} / "scree_program" / name;
  fs::remove_all(folder);
  return folder;
}

[[nodiscard]] std::string scene_file(const std::string& name) {
  return std::string{SCREE_TEST_SCENES} + "/" + name + ".toml";
}

[[nodiscard]] std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream{file}.rdbuf();
  return text.str();
}

/// Starts the column with frames every 0.01 s in a process of its own.
[[nodiscard]] pid_t start_column(const fs::path& directory, std::uint64_t largest_file = 0) {
  const std::string scene = scene_file("inclined_plane_column");
  const pid_t child = fork();
  if (child != 0) return child;
  if (largest_file > 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{largest_file, largest_file};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  execl(SCREE_PROGRAM, SCREE_PROGRAM, "run", scene.c_str(), "--output", directory.c_str(), "--quiet", "--set",
        "output.every=0.01", "--set", "output.checkpoint_every=0.02", nullptr);
  _exit(127);
}

/// Waits for a number of frames to be there, at most a minute.
void wait_for_frames(const fs::path& directory, std::size_t count) {
  for (int i = 0; i < 6000; ++i) {
    if (fs::exists(directory / "run.h5") && io::FrameReader{directory}.frames().size() >= count) return;
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
}

TEST(Program, LeavesEverythingItPromises) {
  const fs::path directory = fresh("promises");

  const Result result = scree("run " + scene_file("inclined_plane_column") + " --quiet --set time.end=0.05 " +
                              "--set output.every=0.01 --output " + directory.string());

  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_EQ(result.output, "");
  for (const char* file : {"run.h5", "run.xdmf", "scene.toml", "checkpoint.h5", "summary.json"}) {
    EXPECT_TRUE(fs::exists(directory / file)) << file;
  }
  const auto summary = nlohmann::json::parse(text_of(directory / "summary.json"));
  for (const char* key : {"steps", "time", "wall_seconds", "point_updates_per_second", "ns_per_point",
                          "class_mass_drift", "fraction_min", "fraction_max", "fraction_sum_error",
                          "segregation_limit", "steps_by_limit", "limit"}) {
    EXPECT_TRUE(summary.contains(key)) << key;
  }
  EXPECT_EQ(summary["time"], 0.05);
  EXPECT_EQ(io::FrameReader{directory}.frames().size(), 6U);
}

TEST(Program, ProfileIsCsvInSiUnits) {
  const fs::path directory = fresh("profile");
  ASSERT_EQ(scree("run " + scene_file("inclined_plane_column") + " --quiet --set time.end=0.02 --output " +
                  directory.string())
                .exit_code,
            0);

  const Result result = scree("profile " + directory.string() + " --time 0 --cells 2");

  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output,
            "y,velocity,mean_grain_size,phi_1,phi_2\n"
            "0.25,0,0.00075,0.5,0.5\n"
            "0.75,0,0.00075,0.5,0.5\n");
}

TEST(Program, BadInputEndsWithCode2AndAMessage) {
  const Result missing = scree("run no_such_scene.toml");
  const Result faulty = scree("check " + scene_file("inclined_plane_column") + " --set mesh.cells=-1");
  const Result unknown = scree("dance");

  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_EQ(missing.output.rfind("no_such_scene.toml: ", 0), 0U) << missing.output;
  EXPECT_EQ(faulty.exit_code, 2);
  EXPECT_EQ(faulty.output.rfind("--set mesh.cells=-1: ", 0), 0U) << faulty.output;
  EXPECT_EQ(unknown.exit_code, 2);
}

TEST(Program, CheckTellsWhatARunCosts) {
  const std::string check = "check " + scene_file("inclined_plane_column_c");
  const Result result = scree(check);
  const Result of_one_mean =
      scree(check + " --set numerics.shape=quadratic --set numerics.averaged_pressure=true");

  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.output.find("points   150 ("), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("cells    51\n"), std::string::npos);
  EXPECT_NE(result.output.find("bound by the acoustic limit"), std::string::npos);
  EXPECT_NE(result.output.find("warning: this two-way coupling is ill-posed"), std::string::npos);
  constexpr const char* warning = "warning: [numerics] averaged_pressure = true without";
  EXPECT_EQ(result.output.find(warning), std::string::npos);
  EXPECT_NE(of_one_mean.output.find(warning), std::string::npos);
}

/// Also where it is quiet.
TEST(Program, RunWarnsOfOneMeanOverCellsWithoutTheOther) {
  const std::string run = "run " + scene_file("inclined_plane_column") +
                          " --quiet --set time.end=1e-6 --set numerics.shape=quadratic" +
                          " --set numerics.averaged_pressure=true --output " + fresh("one_mean").string();

  const Result of_one = scree(run);
  const Result of_both = scree(run + " --set numerics.averaged_volume_change=true");

  EXPECT_EQ(of_one.exit_code, 0);
  EXPECT_EQ(of_one.output.rfind("scree: warning: [numerics] averaged_pressure = true without ", 0), 0U)
      << of_one.output;
  EXPECT_EQ(std::ranges::count(of_one.output, '\n'), 1) << of_one.output;
  EXPECT_EQ(of_both.exit_code, 0);
  EXPECT_EQ(of_both.output, "");
}

TEST(Program, LeadsAPointAlongAPathAndDrawsIt) {
  const fs::path directory = fresh("path");

  const Result result =
      scree("path " SCREE_TEST_PATHS "/triaxial_drained.toml --output " + directory.string());

  EXPECT_EQ(result.exit_code, 0) << result.output;
  for (const char* file : {"path.csv", "path.png", "path.svg"}) {
    EXPECT_TRUE(fs::exists(directory / file)) << file;
    EXPECT_NE(result.output.find((directory / file).string() + "\n"), std::string::npos) << result.output;
  }
}

/// Sand bears no more shear stress than friction times pressure: with sigma_yy held at 196 kPa it bears the
/// 100 kPa of the first step, not the 200 kPa of the second. What came before is kept.
TEST(Program, PathWithoutAnAnswerEndsWithCode3AndKeepsWhatItHad) {
  const fs::path directory = fresh("path_without_answer");
  const std::string file = directory.string() + ".toml";
  fs::create_directories(directory);
  std::ofstream{file} << text_of(SCREE_TEST_PATHS "/triaxial_drained.toml") << R"(
[[stages]]
name = "creep"
duration = 1
steps = 10
stress_rates = { xy = 1e6, yy = 0 }
)";

  const Result result = scree("path " + file + " --no-picture --output " + directory.string());

  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.output.rfind("scree: the law 'drucker_prager' has no answer in stage 3 'creep' at ", 0),
            0U)
      << result.output;
  EXPECT_EQ(std::ranges::count(text_of(directory / "path.csv"), '\n'), 243);  // header, start, 241 steps
}

/// Without a floor the lowest points, 3 mm above the end of the mesh, fall out of it in 0.03 s.
TEST(Program, FailedRunEndsWithCode3AndKeepsWhatItHad) {
  const fs::path directory = fresh("failed");

  const Result result =
      scree("run " + scene_file("inclined_plane_column") + " --quiet --set boundaries.y_low=open " +
            "--set output.every=0.01 --output " + directory.string());

  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.output.rfind("scree: the run failed at step ", 0), 0U) << result.output;
  EXPECT_GE(io::FrameReader{directory}.frames().size(), 1U);
  EXPECT_TRUE(fs::exists(directory / "checkpoint.h5"));
  EXPECT_EQ(text_of(directory / "summary.json").find("\"outcome\": \"failed: "), 4U);
}

/// A point of 1e308 m/s has more momentum than a number holds, and what is beside it no volume after a step;
/// that all of them have left the mesh by then, to be absorbed, does not hide it.
TEST(Program, RunWhoseVelocitiesOverflowEndsWithCode3AndItsSummary) {
  const fs::path directory = fresh("overflow");
  const std::string run = "run " + scene_file("inclined_plane_column") + " --quiet --set output.every=0.01 " +
                          "--set boundaries.leaving=absorb --output " + directory.string() +
                          " --set time.end=";
  ASSERT_EQ(scree(run + "0.01").exit_code, 0);
  const fs::path checkpoint = directory / "checkpoint.h5";
  Simulation<1, 2> column{scene_of("inclined_plane_column"), {1}};
  read_checkpoint_into(column, checkpoint);
  auto& particles = column.state.particles;
  Index middle = 0;
  while (particles.position.component(0)[middle] < 0.5 || particles.mass.component(0)[middle] == 0) ++middle;
  particles.velocity.component(0)[middle] = 1e308;
  write_checkpoint(column, checkpoint, "");

  const Result result = scree(run + "0.02 --restart " + checkpoint.string());

  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.output.find(" has no volume left after a step of "), std::string::npos) << result.output;
  const std::string outcome = nlohmann::json::parse(text_of(directory / "summary.json"))["outcome"];
  EXPECT_EQ(outcome.rfind("failed: material point ", 0), 0U) << outcome;
}

/// A run that begins to go wrong in its first step ends like one that does so later.
TEST(Program, RestartWhoseRatesAreNoNumbersEndsWithCode3AndItsSummary) {
  const fs::path directory = fresh("no_rates");
  const std::string run = "run " + scene_file("inclined_plane_column") + " --quiet --output " +
                          directory.string() + " --set time.end=";
  ASSERT_EQ(scree(run + "0.01").exit_code, 0);
  const fs::path checkpoint = directory / "checkpoint.h5";
  Simulation<1, 2> column{scene_of("inclined_plane_column"), {1}};
  read_checkpoint_into(column, checkpoint);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  column.state.rates = {none, none, none, none};
  write_checkpoint(column, checkpoint, "");

  const Result result = scree(run + "0.02 --restart " + checkpoint.string());

  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(nlohmann::json::parse(text_of(directory / "summary.json"))["outcome"],
            "failed: stable_time_step: nothing bounds the step; give a maximum");
}

/// A column that thickens as it is sheared, mu = 1e4 Pa s^2 times the shear rate, under FLIP on hat
/// functions. At rest sound alone bounds its step. Under 30 degrees the shear stress, 4905 Pa/m times the
/// depth, leads to a viscosity of two thirds of the largest in the mean, and at the viscous limit to a sum of
/// 8/9 or more, of 0.59 that hold. Before that the waves that grow have thickened it so that steps collapse.
const std::string thickening_column = R"([mesh]
dimensions = 1
velocity_components = 2
size = [1.0]
cells = 8
[boundaries]
y_low = "no_slip"
y_high = "slip"
[material]
low = [0.0]
high = [0.75]
[gravity]
slope_degrees = 30
[rheology]
law = "herschel_bulkley"
yield_stress = 0
regularisation_time = 1000
consistency = 1e4
exponent = 2
bulk_modulus = 1e6
density = 1000
[numerics]
transfer = "pic_flip"
increment_share = 1
viscous = 1
[time]
end = 10
)";

/// That column, looked at with frames.
struct UnstableRun {
  std::string scene;    ///< its file
  std::string command;  ///< that runs it
  fs::path checkpoint;
  Result result;
  io::FrameReader frames;
  double time;  ///< of its end [s]
};

[[nodiscard]] UnstableRun unstable_run(const std::string& name) {
  const fs::path directory = fresh(name);
  const std::string file = directory.string() + ".toml";
  fs::create_directories(directory);
  std::ofstream{file} << thickening_column + "[output]\nevery = 0.01\n";
  const std::string command = "run " + file + " --quiet --output " + directory.string();
  const Result result = scree(command);
  const auto summary = nlohmann::json::parse(text_of(directory / "summary.json"));
  return {file, command, directory / "checkpoint.h5", result, io::FrameReader{directory}, summary["time"]};
}

/// Names of all that a summary has, those inside of another as "limit.dt".
void collect_keys(const nlohmann::json& json, const std::string& within, std::set<std::string>& keys) {
  for (const auto& [key, value] : json.items()) {
    const auto& one = value.is_array() && !value.empty() ? value[0] : value;
    if (one.is_object()) {
      collect_keys(one, within + key + ".", keys);
    } else {
      keys.insert(within + key);
    }
  }
}

/// Those that docs/tutorials/output_files.md has in the first column of its table of them.
[[nodiscard]] std::set<std::string> keys_of_table() {
  const std::string page = text_of(std::string{SCREE_TEST_SCENES} + "/../../docs/tutorials/output_files.md");
  const std::string table = page.substr(page.find("| key |"));
  std::istringstream rows{table.substr(0, table.find("\n\n"))};
  std::set<std::string> keys;
  for (std::string row; std::getline(rows, row);) {
    const std::string names = row.substr(0, row.find('|', 1));
    const std::regex quoted{"`([^`]+)`"};
    for (std::sregex_iterator name{names.begin(), names.end(), quoted}; name != std::sregex_iterator{};
         ++name) {
      keys.insert((*name)[1]);
    }
  }
  return keys;
}

/// Two sizes segregate in a chute that is fed and emptied, by a law that tells where it is ill-posed: every
/// key is there.
TEST(Summary, HasTheKeysOfItsTable) {
  Simulation<2, 2> chute{
      scene_of("fed_chute", {"grains.diameters=[1e-3, 2e-3]", "grains.fractions=[0.5, 0.5]",
                             "segregation.closure=shear_rate", "segregation.c=1e-5", "segregation.every=1"}),
      {1}};
  for (int i = 0; i < 20; ++i) chute.step();
  std::set<std::string> keys;
  collect_keys(nlohmann::json::parse(summary_json(chute, 1, "finished")), "", keys);

  EXPECT_EQ(keys, keys_of_table());
}

/// The share that a run was stopped for, set to the largest that the message allows.
[[nodiscard]] std::string named_share(const std::string& message) {
  std::smatch parts;
  const std::regex named{R"(\[numerics\] (\w+) = .*: give at most ([0-9.e-]+);)"};
  if (!std::regex_search(message, parts, named)) return "";
  return "numerics." + parts[1].str() + "=" + parts[2].str();
}

TEST(Program, RunThatBecomesUnstableEndsWithCode3AndAllItHad) {
  const UnstableRun run = unstable_run("unstable");

  EXPECT_EQ(run.result.exit_code, 3);
  EXPECT_EQ(run.result.output.rfind("scree: the run failed at step ", 0), 0U) << run.result.output;
  EXPECT_NE(run.result.output.find(" s: the run has become unstable: [numerics] "), std::string::npos)
      << run.result.output;
  EXPECT_EQ(run.frames.frames().back().time, run.time);
  EXPECT_EQ(run.frames.read(run.frames.frames().back(), "mass").size(), 18U);
}

/// Though no checkpoint was due.
TEST(Program, UnstableRunGoesOnFromWhereItWasStoppedWithTheShareThatItNames) {
  const UnstableRun run = unstable_run("unstable_restart");
  const std::string share = named_share(run.result.output);
  const std::string end = std::to_string(run.time + 0.01);
  const std::string restart =
      run.command + " --restart " + run.checkpoint.string() + " --set time.end=" + end;

  Simulation<1, 2> stored{read_scene(run.scene, {share}).scene, {1}};
  read_checkpoint_into(stored, run.checkpoint);
  const Result with_old_share = scree(restart);
  const Result with_new_share = scree(restart + " --set " + share);

  EXPECT_EQ(stored.clock.time, run.time);
  EXPECT_EQ(with_old_share.exit_code, 2) << with_old_share.output;
  EXPECT_EQ(with_new_share.exit_code, 0) << with_new_share.output;
  EXPECT_EQ(io::FrameReader{run.checkpoint.parent_path()}.frames().size(), run.frames.frames().size() + 1);
}

[[nodiscard]] bool is_unstable(const Simulation<1, 2>& simulation) {
  try {
    simulation.require_stable();
  } catch (const RunError&) {
    return true;
  }
  return false;
}

/// The first step after which waves grow is made that of number 20 000, by the checkpoint from which it
/// starts.
TEST(Program, RunWithoutFramesIsStoppedByTheNumberOfItsSteps) {
  const fs::path directory = fresh("unstable_without_frames");
  const fs::path checkpoint = directory / "checkpoint.h5";
  const std::string file = directory.string() + ".toml";
  fs::create_directories(directory);
  std::ofstream{file} << thickening_column;
  const std::string run = "run " + file + " --quiet --output " + directory.string();
  ASSERT_EQ(scree(run + " --set time.end=0.001").exit_code, 0);
  Simulation<1, 2> begun{read_scene(file, {}).scene, {1}};
  Simulation<1, 2> ahead{read_scene(file, {}).scene, {1}};
  read_checkpoint_into(begun, checkpoint);
  read_checkpoint_into(ahead, checkpoint);
  for (int n = 0; n < 20000 && !is_unstable(ahead); ++n) ahead.step();
  ASSERT_TRUE(is_unstable(ahead));
  begun.clock.step = 20000 - (ahead.clock.step - begun.clock.step);
  write_checkpoint(begun, checkpoint, "");

  const Result result = scree(run + " --restart " + checkpoint.string());

  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.output.rfind("scree: the run failed at step 20000, t = ", 0), 0U) << result.output;
  EXPECT_NE(result.output.find(" s: the run has become unstable: [numerics] "), std::string::npos)
      << result.output;
  Simulation<1, 2> stored{read_scene(file, {named_share(result.output)}).scene, {1}};
  read_checkpoint_into(stored, checkpoint);
  EXPECT_EQ(stored.clock.time, ahead.clock.time);
}

TEST(Program, RunWhoseEndIsReachedBeforeWavesGrowIsFinished) {
  const UnstableRun run = unstable_run("unstable_after_end");

  const Result result = scree(run.command + " --set time.end=" + std::to_string(run.time));

  EXPECT_EQ(result.exit_code, 0) << result.output;
}

/// A stream of 2 x 2 points a cell, 0.1 m long when it begins, that crosses a mesh of 1 m at 1 m/s, without
/// weight: each point has the same mass, and nothing changes its speed.
[[nodiscard]] std::string crossing() {
  return open_channel() + "[gravity]\nmagnitude = 0\n" + stream_of_1_m_per_s() + fluid_of_streams() +
         "[time]\nend = 1.2\n";
}

[[nodiscard]] nlohmann::json summary_of(const std::string& name, const std::string& scene) {
  const fs::path directory = fresh(name);
  fs::create_directories(directory);
  const std::string file = directory.string() + ".toml";
  std::ofstream{file} << scene;
  const Result result = scree("run " + file + " --quiet --threads 1 --output " + directory.string());
  EXPECT_EQ(result.exit_code, 0) << result.output;
  return nlohmann::json::parse(text_of(directory / "summary.json"));
}

/// What has passed has the mass of so many points, and that times 1 m/s of momentum along x.
void expect_passed(const nlohmann::json& passed, std::int64_t points) {
  constexpr double mass_of_point = 1000 * 0.05 * 0.05 / 4;  // [kg] per metre across
  const double mass = mass_of_point * static_cast<double>(points);
  const double rounding = 1e-12 * mass;  // of some hundred sums, and of the speed in a thousand steps
  EXPECT_EQ(passed["points"], points);
  EXPECT_NEAR(passed["mass"].get<double>(), mass, rounding);
  EXPECT_NEAR(passed["momentum"][0].get<double>(), mass, rounding);
  EXPECT_NEAR(passed["momentum"][1].get<double>(), 0, rounding);
}

/// The first of its layers, 0.025 m apart, begins at 0.0875 m: by 1.2 s twelve have come to 1 m, and sixteen
/// to a box from 0.9 m on.
TEST(Program, SummaryHasWhatEnteredWhatWasAbsorbedAndWhatWasTaken) {
  const auto absorbed = summary_of("absorbed", crossing());
  const auto taken = summary_of("taken", crossing() + "[[outflow]]\nlow = [0.9, 0.0]\nhigh = [1.0, 0.5]\n");

  expect_passed(absorbed["absorbed"], 4 * 12);
  expect_passed(taken["outflow"][0], 4 * 16);
  expect_passed(taken["absorbed"], 0);
  for (const auto& summary : {absorbed, taken}) {
    const auto entered = summary["inflow"][0]["points"].get<std::int64_t>();
    EXPECT_GE(entered, 4 * 47);  // 48 layers' time, the last of them just now
    expect_passed(summary["inflow"][0], entered);
    EXPECT_LE(summary["mass_drift"].get<double>(), 1e-12);
  }
}

TEST(Program, CtrlCEndsWithCode130AndTheRestartIsTheUnbrokenRun) {
  const fs::path broken = fresh("interrupted");
  const fs::path whole = fresh("whole");
  const std::string options =
      " --quiet --set output.every=0.01 --set output.checkpoint_every=0.02 --set time.end=";
  const pid_t child = start_column(broken);
  wait_for_frames(broken, 3);
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const auto summary = nlohmann::json::parse(text_of(broken / "summary.json"));
  EXPECT_EQ(summary["outcome"], "interrupted");
  const std::string end = std::to_string(summary["time"].get<double>() + 0.1);

  const Result restarted =
      scree("run " + scene_file("inclined_plane_column") + options + end + " --restart " +
            (broken / "checkpoint.h5").string() + " --output " + broken.string());
  const Result unbroken =
      scree("run " + scene_file("inclined_plane_column") + options + end + " --output " + whole.string());

  EXPECT_EQ(restarted.exit_code, 0) << restarted.output;
  EXPECT_EQ(unbroken.exit_code, 0) << unbroken.output;
  const io::FrameReader a{broken};
  const io::FrameReader b{whole};
  ASSERT_EQ(a.frames().size(), b.frames().size());
  for (const char* field : {"position", "velocity", "fraction"}) {
    EXPECT_EQ(a.read(a.frames().back(), field), b.read(b.frames().back(), field)) << field;
  }
}

TEST(Program, KilledAtAnyMomentLeavesFramesAndCheckpointReadable) {
  for (const int milliseconds : {3, 11, 23, 47, 95}) {
    const fs::path directory = fresh("killed");
    const pid_t child = start_column(directory);
    wait_for_frames(directory, 2);
    std::this_thread::sleep_for(std::chrono::milliseconds{milliseconds});
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);

    const io::FrameReader reader{directory};
    ASSERT_GE(reader.frames().size(), 2U);
    for (const io::StoredFrame& frame : reader.frames()) EXPECT_EQ(reader.read(frame, "mass").size(), 150U);
    const Result result = scree("run " + scene_file("inclined_plane_column") +
                                " --quiet --set output.every=0.01 --set time.end=0.01 --restart " +
                                (directory / "checkpoint.h5").string() + " --output " + directory.string());
    EXPECT_EQ(result.exit_code, 0) << result.output;
  }
}

/// A disk that takes no file beyond 30 kB: the first frames fit, the index of frames soon does not.
TEST(Program, FullDiskEndsWithCode3AndEarlierFramesStay) {
  const fs::path directory = fresh("full_disk");
  const pid_t child = start_column(directory, 40000);
  int status = 0;
  waitpid(child, &status, 0);

  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3);
  const io::FrameReader reader{directory};
  EXPECT_GE(reader.frames().size(), 1U);
  EXPECT_EQ(reader.read(reader.frames().back(), "mass").size(), 150U);
}

}  // namespace
}  // namespace scree::app::testing
