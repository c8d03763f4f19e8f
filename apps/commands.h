#pragma once
/// \file
/// The commands of the program as plain data, and the functions that execute them.

#include "apps/terminal/words.h"
#include "matching/experiment/options.h"

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace shellmatch {

/// The settings that `match` and `run` share. A setting that was not given is an empty text.
struct RunSettings {
  std::string output;  ///< output folder
  std::string levels, align, placement, profile, threads;
  std::string landmarks, template_landmarks;  ///< files
  bool strict = false;                        ///< input.close=never
  std::vector<std::string> assignments;       ///< values of --set, in their order
  std::string fail_on;                        ///< verdict from which on the program fails (run and match)
  Verbosity verbosity = Verbosity::normal;
  bool force = false, restart = false;
};

struct MatchCommand {
  std::string reference, template_shape;
  RunSettings settings;
};

struct RunCommand {
  std::string config;
  RunSettings settings;
};

struct GenerateCommand {
  std::string shape;                     ///< "hand" or "hand/bent"; empty to list all shapes
  std::string output;                    ///< output file
  std::vector<std::string> assignments;  ///< PARAMETER=VALUE
  std::string edge_length;
  bool list = false, force = false;
};

struct ApplyCommand {
  std::string deformation, file, output;
  std::string like;      ///< a volume whose voxels the output has
  std::string sampling;  ///< of a volume: nearest, label, linear; empty for what its values ask for
  std::string displacement, jacobian, log_jacobian;  ///< volumes to write
  bool inverse = false;                              ///< from the template back to the reference
  bool keep_pose = false;                            ///< points on the template are in the pose of the reference
  bool force = false;
};

struct InspectCommand {
  std::string file;
  bool json = false;
};

struct CurvatureCommand {
  std::string shape;
  std::string degree, rings;  ///< of the fit to the mesh
  RunSettings settings;
};

struct CheckGradientCommand {
  std::string config;
  std::string level, state, directions, json;  ///< empty if not given; json is the name of a file
  RunSettings settings;                        ///< without output and levels
};

struct SelfTestCommand {
  std::string threads;
  Verbosity verbosity = Verbosity::normal;
};

struct ViewCommand {
  std::string folder;       ///< of a result, or its report
  bool print_only = false;  ///< open nothing
};

struct RenderCommand {
  std::string folder, output;
  std::string show, colors, azimuth, elevation, time, size, motion, frames, seconds, quality;  ///< empty if not given
  bool force = false;
};

struct ConfigCommand {
  std::string profile;
  bool markdown = false;
};

struct StudyCommand {
  std::string study, output;
  std::vector<std::string> assignments;  ///< values of --set: options of an experiment, for all runs
  std::vector<std::string> only;         ///< names of runs; empty for all
  std::string jobs, program;
  bool list = false, collect = false, retry = false;
  Verbosity verbosity = Verbosity::normal;
};

struct CohortCommand {
  std::vector<std::string> shapes;  ///< files and patterns, or the one YAML file of a cohort
  std::string table, output, atlas, kind, atlas_landmarks, levels;
  std::vector<std::string> assignments;  ///< values of --set: options of the cohort, or of the experiment
  std::vector<std::string> only;         ///< ids; empty for all
  std::string shard, stage, jobs, program;
  bool list = false, list_stages = false, collect = false, retry = false, options = false;
  Verbosity verbosity = Verbosity::normal;
};

/// Prints a text that was requested: help or version.
struct PrintCommand {
  std::string text;
};

using Command = std::variant<MatchCommand, RunCommand, GenerateCommand, ApplyCommand, InspectCommand, CurvatureCommand,
                             CheckGradientCommand, SelfTestCommand, ViewCommand, RenderCommand, ConfigCommand,
                             StudyCommand, CohortCommand, PrintCommand>;

/// A check was performed and failed: exit code 1.
class CheckFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Executes a command. \throws InputError, EnvironmentError, CheckFailed, or Stopped (base/stop.h) if a signal stopped
/// it
void execute(const MatchCommand& command);
void execute(const RunCommand& command);
void execute(const GenerateCommand& command);
void execute(const ApplyCommand& command);
void execute(const InspectCommand& command);
void execute(const CurvatureCommand& command);
void execute(const CheckGradientCommand& command);
void execute(const SelfTestCommand& command);
void execute(const ViewCommand& command);
void execute(const RenderCommand& command);
void execute(const ConfigCommand& command);
void execute(const StudyCommand& command);
void execute(const CohortCommand& command);
void execute(const PrintCommand& command);

}  // namespace shellmatch
