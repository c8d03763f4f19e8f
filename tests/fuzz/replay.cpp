// Reads the kept corpus of every target, or of one, without libFuzzer: what any compiler with sanitizers can do. With a
// number of seconds it changes the inputs at random for so long, without the guidance of coverage.
//
//     fuzz_replay CORPUS_FOLDER [TARGET [SECONDS [SEED]]]
#include "tests/fuzz/kept_inputs.h"
#include "tests/fuzz/run_input.h"

#include <sanitizer/common_interface_defs.h>
#include <sys/time.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed);

namespace {

using namespace shellmatch::fuzz;

std::mt19937 random_bits;
std::vector<std::string> inputs;  // of the target; also what is put together with them

std::size_t below(std::size_t n) { return n == 0 ? 0 : random_bits() % n; }

// The input that is being read is left behind by a crash.
constexpr unsigned most_seconds = 30;  // of all cores together, so that a busy machine ends none
std::string current_input, crash_name;

void keep_input() {
  std::ofstream(crash_name, std::ios::binary) << current_input;
  std::fprintf(stderr, "the input is in %s\n", crash_name.c_str());
}

void end_by_signal(int signal) {
  if (signal == SIGPROF) std::fprintf(stderr, "an input takes more than %u seconds of the processor\n", most_seconds);
  else std::fputs("an input ends the program\n", stderr);
  keep_input();
  std::_Exit(1);
}

// Seconds of the processor; 0 for no limit.
void end_after(unsigned seconds) {
  const itimerval limit{{}, {static_cast<time_t>(seconds), 0}};
  demand(setitimer(ITIMER_PROF, &limit, nullptr) == 0, "a time limit can be set");
}

// Returns why it was refused.
std::string read_input(const Target& target, const std::string& input) {
  current_input = input;
  end_after(most_seconds);
  std::string refusal = run_input(target, input);
  end_after(0);
  return refusal;
}

void replay(const Target& target, const std::string& folder, double seconds) {
  setenv("SHELLMATCH_FUZZ_TARGET", std::string(target.name).c_str(), 1);
  crash_name = "crash-" + std::string(target.name);
  inputs = kept_inputs(folder + "/" + std::string(target.name) + ".txt");
  demand(!inputs.empty(), "a target has kept inputs");
  // Seeds of a format that has changed reach nothing of the reader.
  std::size_t n_read = 0;
  std::string refusal_of_longest;
  std::size_t longest = 0;
  for (const std::string& input : inputs) {
    const std::string refusal = read_input(target, input);
    n_read += refusal.empty() ? 1 : 0;
    if (input.size() >= longest) {
      longest = input.size();
      refusal_of_longest = refusal;
    }
  }
  const int width = static_cast<int>(target.name.size());
  if (n_read == 0) std::fprintf(stderr, "%.*s: %s\n", width, target.name.data(), refusal_of_longest.c_str());
  demand(n_read > 0, "one of the kept inputs of a target is read");
  std::printf("%.*s: %zu kept inputs, %zu of them read", width, target.name.data(), inputs.size(), n_read);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::size_t n_runs = 0;
  std::vector<std::uint8_t> data(20000);
  for (; std::chrono::steady_clock::now() < end; ++n_runs) {
    const std::string& from = inputs[below(inputs.size())];
    std::size_t size = std::min(from.size(), data.size());
    std::copy_n(from.begin(), size, data.begin());
    for (std::size_t k = 1 + below(4); k > 0; --k) size = LLVMFuzzerCustomMutator(data.data(), size, data.size(), 0);
    read_input(target, std::string(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(size)));
  }
  std::printf(seconds > 0 ? ", %zu changed ones\n" : "\n", n_runs);
  std::fflush(stdout);
}

}  // namespace

// One change: a bit, a byte, a number at its limits, a piece left out, doubled, or taken from another input.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size) {
  constexpr std::uint8_t telling[] = {0, 1, 9, 10, 32, 44, 45, 46, 48, 57, 127, 128, 255};
  const std::size_t at = below(size + 1), n = std::min(below(40) + 1, size - at);
  switch (below(6)) {
    case 0:
      if (at < size) data[at] ^= static_cast<std::uint8_t>(1u << below(8));
      return size;
    case 1:
      if (at < size) data[at] = telling[below(std::size(telling))];
      return size;
    case 2:
      for (std::size_t k = 0; k < std::min<std::size_t>(n, 8); ++k) data[at + k] = telling[below(2) * 12];
      return size;
    case 3: std::copy(data + at + n, data + size, data + at); return size - n;
    case 4: {
      if (size + n > max_size) return size;
      const std::vector<std::uint8_t> piece(data + at, data + at + n);
      std::copy_backward(data + at, data + size, data + size + n);
      std::copy(piece.begin(), piece.end(), data + at);
      return size + n;
    }
    default: {
      const std::string& other = inputs[below(inputs.size())];
      const std::size_t from = below(other.size()), m = std::min({below(40) + 1, other.size() - from, max_size - size});
      std::copy_backward(data + at, data + size, data + size + m);
      std::copy_n(other.begin() + static_cast<std::ptrdiff_t>(from), m, data + at);
      return size + m;
    }
  }
}

int main(int argc, char** argv) {
  if (argc < 2 || argc > 5) {
    std::fprintf(stderr, "usage: fuzz_replay CORPUS_FOLDER [TARGET [SECONDS [SEED]]]\n");
    return 2;
  }
  for (const int signal : {SIGPROF, SIGABRT}) std::signal(signal, end_by_signal);
  __sanitizer_set_death_callback(keep_input);
  random_bits.seed(argc > 4 ? static_cast<unsigned>(std::atoi(argv[4])) : 1);
  const double seconds = argc > 3 ? std::atof(argv[3]) : 0;
  if (argc > 2 && std::string(argv[2]) != "all") {
    replay(target_named(argv[2]), argv[1], seconds);
    return 0;
  }
  for (const Target& target : targets()) replay(target, argv[1], seconds);
}
