#include "scree/run/run.hpp"

#include "scree/assemble/make_stages.hpp"
#include "scree/assemble/overlaps.hpp"
#include "scree/run/frames.hpp"
#include "scree/run/interrupt.hpp"
#include "scree/run/progress.hpp"
#include "scree/run/restart.hpp"
#include "scree/run/stability.hpp"
#include "scree/run/summary.hpp"
#include "scree/run/well_posedness.hpp"
#include "scree/scene/with_dimensions.hpp"

#include <scree/io/replace_file.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>

namespace scree::app {

namespace {

/// Between looks at whether waves grow, where no frame is due: a look at few points takes as long as some ten
/// steps of them, at many as one or two, and so less than a thousandth of the run on one thread.
constexpr std::int64_t steps_between_looks = 20000;

/// Copies what lies beside a scene to the same place beside its results, so that these stand on their own.
void keep_files(const std::vector<FileOfScene>& files, const std::filesystem::path& directory) {
  for (const FileOfScene& file : files) {
    const std::filesystem::path copy = directory / file.name;
    std::error_code error;
    if (file.name.is_absolute() || std::filesystem::equivalent(file.path, copy, error)) continue;
    error.clear();
    std::filesystem::create_directories(copy.parent_path(), error);
    if (!error) {
      std::filesystem::copy_file(file.path, copy, std::filesystem::copy_options::overwrite_existing, error);
    }
    if (error) throw RunError{copy.string() + ": cannot be written: " + error.message()};
  }
}

/// One run and what it leaves in its directory.
template <int D, int V>
class RunOnDisk {
 public:
  RunOnDisk(const ReadScene& scene, const RunOptions& options)
      : options_{options},
        scene_text_{scene.text},
        simulation_{scene.scene, options.threads},
        soft_{softness_warning(simulation_)},
        frames_{open_frames()},
        progress_{options.is_quiet, simulation_.clock.time} {
    io::replace_file(options.directory / "scene.toml", scene.text);
    keep_files(scene.files, options.directory);
  }

  Outcome run() {
    if (const auto& note = simulation_.viscosity_note(); !note.empty() && !options_.is_quiet) {
      fmt::print("{}\n", note);
    }
    if (const std::string few = simulation_.too_few_points(); !few.empty()) {
      fmt::print(stderr, "scree: warning: {}\n", few);
    }
    if (!soft_.empty()) fmt::print(stderr, "scree: warning: {}\n", soft_);
    const Scene& scene = simulation_.scene();
    const std::string walls = wall_under_ground_warning(scene, simulation_.grid(), ground_of<D>(scene));
    if (!walls.empty()) fmt::print(stderr, "scree: warning: {}\n", walls);
    const InterruptGuard guard;
    Outcome outcome = Outcome::finished;
    std::optional<Standing> last;
    const auto fail = [&](const std::exception& error) {
      outcome = Outcome::failed;
      failure_ = error.what();
    };
    try {
      last = standing();
      if (!options_.restart) store_frame();
      while (!simulation_.is_finished() && !guard.is_interrupted()) {
        const bool is_due = simulation_.step();
        warn();
        if (is_due) {
          store_frame();
        } else if (simulation_.clock.step % steps_between_looks == 0) {
          require_stable();
        }
        last = standing();
        progress_.update(*last);
      }
      if (!simulation_.is_finished()) outcome = Outcome::interrupted;
      checkpoint();
    } catch (const RunError& error) {
      fail(error);
    } catch (const InputError& error) {  // nothing bounds the step: rates have become no numbers
      fail(error);
    }
    if (last) progress_.finish(*last);
    if (const auto share = simulation_.ill_posed_share(); share && !options_.is_quiet) {
      fmt::print("{:.1f} % of the points are where the law is ill-posed (C > 0)\n", 100 * *share);
    }
    finish(outcome);
    return outcome;
  }

 private:
  [[nodiscard]] io::FrameWriter open_frames() {
    if (!options_.restart) return io::FrameWriter::create(options_.directory);
    read_checkpoint_into(simulation_, *options_.restart);
    return io::FrameWriter::resume(options_.directory, simulation_.clock.step);
  }

  void store_frame() {
    write_frame(simulation_, frames_);
    require_stable();
    if (simulation_.clock.time >= next_checkpoint_) checkpoint();
  }

  /// What is there is kept, stable or not, to go on from. In no step after the end can waves grow.
  void require_stable() {
    try {
      if (!simulation_.is_finished()) simulation_.require_stable();
    } catch (const RunError&) {
      checkpoint();
      throw;
    }
  }

  /// Of what the last step has found.
  void warn() {
    const std::string warning = simulation_.take_warning();
    if (warning.empty()) return;
    progress_.leave_line();
    fmt::print(stderr, "scree: warning: {}\n", warning);
  }

  void checkpoint() {
    write_checkpoint(simulation_, options_.directory / "checkpoint.h5", scene_text_);
    const double every = simulation_.scene().output.checkpoint_every;
    next_checkpoint_ = every * (std::floor(simulation_.clock.time / every) + 1);
  }

  [[nodiscard]] Standing standing() const {
    return {simulation_.clock.time, simulation_.scene().end, simulation_.next_step(),
            simulation_.point_updates()};
  }

  void finish(Outcome outcome) {
    const std::string word = outcome == Outcome::finished      ? "finished"
                             : outcome == Outcome::interrupted ? "interrupted"
                                                               : "failed: " + failure_;
    if (outcome == Outcome::failed) {
      fmt::print(stderr,
                 "scree: the run failed at step {}, t = {:g} s: {}\nscree: frames until then and the last "
                 "checkpoint are in {}\n",
                 simulation_.clock.step, simulation_.clock.time, failure_, options_.directory.string());
    }
    try {
      io::replace_file(options_.directory / "summary.json",
                       summary_json(simulation_, progress_.seconds(), word));
    } catch (const RunError& error) {
      fmt::print(stderr, "scree: {}\n", error.what());
    }
  }

  RunOptions options_;
  std::string scene_text_;
  Simulation<D, V> simulation_;
  std::string soft_;  // what to say of the start, of a restart's too, by the constants of this scene
  io::FrameWriter frames_;
  Progress progress_;
  double next_checkpoint_ = 0;  // [s]
  std::string failure_;
};

}  // namespace

Outcome run_scene(const ReadScene& scene, const RunOptions& options) {
  for (const std::string& warning : {ill_posedness_warning(scene.scene), one_mean_warning(scene.scene)}) {
    if (!warning.empty()) fmt::print(stderr, "scree: warning: {}\n", warning);
  }
  return with_dimensions(scene.scene, [&](auto dimensions, auto components) {
    return RunOnDisk<dimensions(), components()>{scene, options}.run();
  });
}

}  // namespace scree::app
