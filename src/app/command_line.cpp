#include "app/command_line.hpp"

#include "app/build_info.hpp"
#include "app/commands.hpp"
#include "app/comparison/synthetic_settings.hpp"
#include "core/error.hpp"
#include "io/comparison_file.hpp"
#include "io/host.hpp"
#include "io/scene_file.hpp"
#include "render/frame_renderer.hpp"

#include <exception>
#include <functional>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>

namespace eisph {
namespace {

constexpr int kThreadsMax = 1024;

/// What the command line asked for; the command to run stays empty until one is named.
struct CommandLine {
  RunOptions run;
  CheckOptions check;
  RenderOptions render;
  ViewOptions view;
  VideoOptions video;
  ValidateOptions validate;
  ParetoOptions pareto;
  StabilityOptions stability;
  CompareOptions compare;
  PhotographOptions photograph;
  bool schema = false;
  std::function<int()> command;
};

void add_overrides(CLI::App& app, std::vector<std::string>& overrides) {
  app.add_option("--set", overrides, "Set a key of the scene: section.key=value; may be given again")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_only(CLI::App& app, std::vector<std::string>& texts, const std::string& which) {
  app.add_option("--only", texts, "Only " + which + "; may be given again")
      ->type_name("TEXT")
      ->allow_extra_args(false);
}

void add_threads(CLI::App& app, int& threads) {
  threads = std::max(1, static_cast<int>(host_info().cores));
  app.add_option("--threads", threads, "Threads of the simulation")
      ->type_name("N")
      ->check(CLI::Range(1, kThreadsMax).description(""))
      ->capture_default_str();
}

void add_context(CLI::App& app, std::string& context) {
  app.add_option("--context", context, "What draws: auto, osmesa, egl (no display) or window")
      ->type_name("KIND")
      ->capture_default_str();
}

/// Prints a reference instead of carrying the command out.
void print_instead(CommandLine& line, std::string (*text)()) {
  line.command = [text] {
    std::cout << text();
    return static_cast<int>(kSuccess);
  };
}

void add_run(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("run", "Simulate a scene and write its frames, tables and states");
  command->add_option("SCENE", line.run.scene, "Scene file (.toml)")->required()->type_name("FILE");
  add_overrides(*command, line.run.overrides);
  add_threads(*command, line.run.threads);
  command->add_option("--out", line.run.out, "Folder of the run [out/<scene>]")->type_name("DIR");
  command->add_option("--until", line.run.until, "Stop at this simulated time, s")->type_name("T");
  command->add_flag("--quiet", line.run.quiet, "Print nothing but errors");
  command->add_flag_callback(
      "--no-frames", [&line] { line.run.frames = false; }, "Draw no frames; the result is the same");
  add_context(*command, line.run.context);
  command->callback(
      [&line] { line.command = [&line] { return run_command(line.run, std::cout, std::cerr); }; });
}

void add_check(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("check", "Check a scene and tell what it would simulate and write");
  CLI::Option* scene =
      command->add_option("SCENE", line.check.scene, "Scene file (.toml)")->type_name("FILE");
  add_overrides(*command, line.check.overrides);
  add_threads(*command, line.check.threads);
  command->add_flag("--schema", line.schema, "Print the reference of all keys of a scene file");
  command->callback([&line, scene] {
    if (line.schema) return print_instead(line, scene_schema_text);
    if (scene->count() == 0) throw CLI::RequiredError("SCENE");
    line.command = [&line] { return check_command(line.check, std::cout); };
  });
}

void add_render(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("render", "Draw frames from the saved states of a run");
  command->add_option("RUN_FOLDER", line.render.run_folder, "Folder of a run")->required()->type_name("DIR");
  command->add_option("--image", line.render.images, "Draw only this image; may be given again")
      ->type_name("NAME")
      ->allow_extra_args(false);
  add_overrides(*command, line.render.overrides);
  command->add_option("--time", line.render.times, "Draw only the state at this time, s; may be given again")
      ->type_name("T")
      ->allow_extra_args(false);
  command->add_option("--out", line.render.out, "Folder of the frames [RUN_FOLDER/rendered]")
      ->type_name("DIR");
  add_context(*command, line.render.context);
  command->callback([&line] { line.command = [&line] { return render_command(line.render, std::cout); }; });
}

void add_video(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("video", "Join the frames of a run to H.264 videos, with ffmpeg");
  VideoOptions& options = line.video;
  command->add_option("RUN_FOLDER", options.run_folder, "Folder of a run")->required()->type_name("DIR");
  command->add_option("--image", options.images, "Only the frames of this image; may be given again")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--rate", options.rate, "Frames per second")
      ->type_name("N")
      ->check(CLI::Range(0.1, 240.0))
      ->capture_default_str();
  command->add_option("--frames", options.frames, "Folder of the frames [RUN_FOLDER/frames]")
      ->type_name("DIR");
  command->add_option("--out", options.out, "Folder of the videos [RUN_FOLDER/video]")->type_name("DIR");
  command->callback([&line] { line.command = [&line] { return video_command(line.video, std::cout); }; });
}

void add_view(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("view", "Look at a scene while it runs, or at the states of a run");
  ViewOptions& options = line.view;
  command->add_option("SCENE_OR_RUN", options.subject, "Scene file (.toml) or folder of a run")
      ->required()
      ->type_name("PATH")
      ->check(CLI::ExistingPath.description(""));
  add_overrides(*command, options.overrides);
  add_threads(*command, options.threads);
  command->add_option("--width", options.width, "Width of the window")
      ->type_name("N")
      ->check(CLI::Range(320, 16384).description(""))
      ->capture_default_str();
  command->add_option("--height", options.height, "Height of the window")
      ->type_name("N")
      ->check(CLI::Range(240, 16384).description(""))
      ->capture_default_str();
  command->add_option("--scale", options.scale, "Size of letters and controls [as the display asks]")
      ->type_name("X")
      ->check(CLI::Range(0.5, 4.0).description(""));
  command->add_option("--until", options.until, "Play at once, and close the window at this time, s")
      ->type_name("T")
      ->check(CLI::PositiveNumber.description(""));
  command->add_option("--out", options.out, "Folder of pictures [out/<scene>/view or RUN/view]")
      ->type_name("DIR");
  command->callback([&line] { line.command = [&line] { return view_command(line.view, std::cout); }; });
}

void add_validate(CLI::App& app, CommandLine& line) {
  CLI::App* command =
      app.add_subcommand("validate", "Run cases with known results and report how far off they are");
  command->add_option("CASE", line.validate.cases, "Cases; all of the mode without any")->type_name("NAME");
  CLI::Option* full = command->add_flag("--full", line.validate.full,
                                        "Published resolutions and durations: takes an hour or two");
  command->add_flag("--quick", line.validate.quick, "Short runs, some minutes in all; the default")
      ->excludes(full);
  command->add_flag("--list", line.validate.list, "List the cases");
  command->add_option("--out", line.validate.out, "Folder of the report")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--against", line.validate.against, "Folder of an earlier report, to compare with")
      ->type_name("DIR");
  add_threads(*command, line.validate.threads);
  command->add_flag("--quiet", line.validate.quiet, "Print nothing but errors");
  command->callback(
      [&line] { line.command = [&line] { return validate_command(line.validate, std::cout, std::cerr); }; });
}

void add_pareto(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("pareto", "Compare schemes and time steps by cost and error");
  command->add_option("CASE", line.pareto.cases, "Cases; all without any")->type_name("NAME");
  command->add_flag("--full", line.pareto.full, "Published spacings and durations: takes hours");
  command->add_flag("--list", line.pareto.list, "List the cases");
  add_only(*command, line.pareto.only,
           "settings whose name has this text, such as 'EISPH, phi 0.17' or 'delta-SPH'");
  command->add_option("--repeats", line.pareto.repeats, "Runs of each setting, of which the median counts")
      ->type_name("N")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command
      ->add_option("--peers", line.pareto.peers,
                   "Runs of other programs, each a folder with peer.toml; see the README")
      ->type_name("DIR");
  command->add_option("--out", line.pareto.out, "Folder of the report")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("--quiet", line.pareto.quiet, "Print nothing but errors");
  command->callback(
      [&line] { line.command = [&line] { return pareto_command(line.pareto, std::cout, std::cerr); }; });
}

void add_stability(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("stability", "Find where the schemes are stable on hard cases");
  command->add_option("CASE", line.stability.cases, "Cases; all without any")->type_name("NAME");
  add_only(*command, line.stability.only, "schemes whose name has this text, such as 'EISPH, thesis'");
  command->add_flag("--full", line.stability.full,
                    "More time steps, two spacings and longer runs: takes hours");
  command->add_flag("--list", line.stability.list, "List the cases");
  command->add_option("--out", line.stability.out, "Folder of the report")
      ->type_name("DIR")
      ->capture_default_str();
  add_threads(*command, line.stability.threads);
  command->add_flag("--quiet", line.stability.quiet, "Print nothing but errors");
  command->callback(
      [&line] { line.command = [&line] { return stability_command(line.stability, std::cout); }; });
}

void add_compare(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("compare", "Compare a run with photographs of an experiment");
  CLI::Option* file = command->add_option("COMPARISON", line.compare.comparison, "Comparison file (.toml)")
                          ->type_name("FILE");
  command->add_option("--run", line.compare.run, "Folder of the run [the one that the file names]")
      ->type_name("DIR");
  command->add_option("--out", line.compare.out, "Folder of the comparison [RUN/comparison]")
      ->type_name("DIR");
  add_overrides(*command, line.compare.overrides);
  command->add_flag("--schema", line.schema, "Print the reference of all keys of a comparison file");
  command->add_flag("--quiet", line.compare.quiet, "Print nothing but errors");
  command->callback([&line, file] {
    if (line.schema) return print_instead(line, comparison_schema_text);
    if (file->count() == 0) throw CLI::RequiredError("COMPARISON");
    line.command = [&line] { return compare_command(line.compare, std::cout); };
  });
}

void add_photograph(CLI::App& app, CommandLine& line) {
  CLI::App* command =
      app.add_subcommand("photograph", "Make synthetic photographs of a run, to try compare on");
  PhotographOptions& options = line.photograph;
  CLI::Option* folder =
      command->add_option("RUN_FOLDER", options.run_folder, "Folder of a run")->type_name("DIR");
  command->add_option("--camera", options.camera, "Camera file (.toml) [assets/synthetic_camera.toml]")
      ->type_name("FILE");
  command->add_option("--set", options.overrides, "Set a key of the camera file; may be given again")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_option("--time", options.times, "Photograph only this time, s; may be given again")
      ->type_name("T")
      ->allow_extra_args(false);
  command->add_option("--area", options.area, "Part of the floor: x_min y_min x_max y_max, m [all of it]")
      ->type_name("M");
  command->add_option("--out", options.out, "Folder of the photographs [RUN_FOLDER/photographs]")
      ->type_name("DIR");
  command->add_flag("--schema", line.schema, "Print the reference of all keys of a camera file");
  command->add_flag("--quiet", options.quiet, "Print nothing but errors");
  command->callback([&line, folder] {
    if (line.schema) return print_instead(line, synthetic_schema_text);
    if (folder->count() == 0) throw CLI::RequiredError("RUN_FOLDER");
    line.command = [&line] { return photograph_command(line.photograph, std::cout); };
  });
}

/// Fills `line`; the exit code where there is nothing to run (help, version, an error).
std::optional<int> parse(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    std::cerr << "eisph: " << error.what() << " (see eisph --help)\n";
    return kBadInput;
  }
  return std::nullopt;
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  try {
    CommandLine line;
    CLI::App app("Dam-break waves by explicit incompressible SPH, drawn while they are simulated.", "eisph");
    app.set_version_flag("--version", software_name());
    app.require_subcommand(1);
    app.footer(
        "Units are SI throughout. Exit codes: 0 done, 1 failure, 2 bad input, 3 blow-up, 4 limits of a "
        "validation missed, 130 interrupted.");
    add_run(app, line);
    add_check(app, line);
    add_render(app, line);
    add_view(app, line);
    add_video(app, line);
    add_validate(app, line);
    add_pareto(app, line);
    add_stability(app, line);
    add_compare(app, line);
    add_photograph(app, line);
    if (const auto code = parse(app, argc, argv)) return *code;
    limit_software_renderer_threads();  // before any command starts threads
    return line.command();
  } catch (const InputError& error) {
    std::cerr << "eisph: " << error.what() << '\n';
    return kBadInput;
  } catch (const BlowUpError& error) {
    std::cerr << "eisph: " << error.what() << '\n';
    return kBlowUp;
  } catch (const std::exception& error) {
    std::cerr << "eisph: " << error.what() << '\n';
    return kFailure;
  }
}

}  // namespace eisph
