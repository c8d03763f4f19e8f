#pragma once
/// \file
/// Each command's words and options, which CLI11 writes into its data.

#include "apps/commands.h"

namespace CLI {
class App;
}

namespace shellmatch {

void describe(CLI::App& app, MatchCommand& match);
void describe(CLI::App& app, RunCommand& run);
void describe(CLI::App& app, StudyCommand& study);
void describe(CLI::App& app, CohortCommand& cohort);
void describe(CLI::App& app, CurvatureCommand& curvature);
void describe(CLI::App& app, CheckGradientCommand& check_gradient);
void describe(CLI::App& app, GenerateCommand& generate);
void describe(CLI::App& app, ApplyCommand& apply);
void describe(CLI::App& app, InspectCommand& inspect);
void describe(CLI::App& app, ViewCommand& view);
void describe(CLI::App& app, RenderCommand& render);
void describe(CLI::App& app, ConfigCommand& config);
void describe(CLI::App& app, SelfTestCommand& self_test);

}  // namespace shellmatch
