// `generate`: writes one of the built-in shapes to a file, or lists them.

#include "apps/commands.h"
#include "apps/process/interrupt.h"
#include "apps/output_file.h"
#include "apps/terminal/words.h"
#include "base/error.h"
#include "geometry/generate/generate_shape.h"
#include "matching/experiment/generated_source.h"

#include <iostream>

namespace shellmatch {

namespace {

GeneratorParameters parameters_of(const GenerateCommand& command) {
  GeneratorParameters parameters;
  for (const std::string& assignment : command.assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0)
      throw_input_error("--set {}: expected parameter=value; `shellmatch generate {} --list` lists the parameters",
                        assignment, command.shape);
    parameters[assignment.substr(0, equals)] = number(assignment.substr(equals + 1), "--set " + assignment + ":");
  }
  return parameters;
}

void list_all() {
  for (const GeneratorInfo& info : generator_catalogue()) {
    std::cout << fmt::format("{} ({}D): {}\n", info.name, info.dimension, info.meaning);
    for (const GeneratorVariant& variant : info.variants)
      std::cout << fmt::format("  {:<24}{}\n", info.name + "/" + variant.name, variant.meaning);
  }
  std::cout
      << "The first variant of each is the one without a name. `shellmatch generate NAME --list` lists parameters.\n";
}

void list_one(const GeneratorInfo& info) {
  std::cout << fmt::format("{} ({}D): {}; edges of about {:g}\nVariants:\n", info.name, info.dimension, info.meaning,
                           info.edge_length);
  for (const GeneratorVariant& variant : info.variants)
    std::cout << fmt::format("  {:<16}{}\n", variant.name, variant.meaning);
  std::cout << "Parameters:\n";
  for (const GeneratorParameter& p : info.parameters)
    std::cout << fmt::format("  {:<16}{} ({}{}{}; default {:g})\n", p.name, p.info.meaning, p.info.unit,
                             p.info.unit.empty() ? "" : ", ", range_text(p.info), p.default_value);
}

// \throws InputError for an unknown name, with the known ones
GeneratorInfo info_of(const std::string& name) {
  std::vector<std::string> names;
  for (GeneratorInfo& info : generator_catalogue()) {
    if (info.name == name) return std::move(info);
    names.push_back(info.name);
  }
  const std::string near = nearest_word(name, names);
  throw_input_error("{}: there is no such shape; {}`shellmatch generate --list` lists them", name,
                    near.empty() ? "" : fmt::format("did you mean {}? ", near));
}

}  // namespace

void execute(const GenerateCommand& command) {
  const auto [name, variant] = split_variant(command.shape);
  if (command.list && name.empty()) return list_all();
  const GeneratorInfo info = info_of(name);
  if (command.list) return list_one(info);
  catch_interrupts();
  check_output_file(command.output, info.dimension, command.force);
  const double edge_length = command.edge_length.empty() ? 0 : number(command.edge_length, "--edge-length");
  const auto shape = generate_shape(name, variant, edge_length, parameters_of(command));
  const auto write = [&]<int Dim>(const OriginalShape<Dim>& s) {
    if constexpr (Dim == 3) say_what_is_left_out(command.output, s);
    write_output_file(command.output, s, command.force);
  };
  std::visit(write, shape);
}

}  // namespace shellmatch
