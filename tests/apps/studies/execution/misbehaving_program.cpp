// Stands in for shellmatch in the tests of studies. Called as `misbehaving_program run CONFIG -o DIR`, it
// does what the solver's name in CONFIG stands for below, and for any other solver it becomes the real
// program.

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  std::ifstream in(argc > 2 ? argv[2] : "");
  const std::string config((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const auto solver_is = [&](const char* name) {
    return config.find("  name: \"" + std::string(name) + "\"\n") != std::string::npos;
  };
  if (solver_is("lbfgs")) raise(SIGSEGV);
  if (solver_is("ceres_ncg")) {
    // Hangs, is deaf to requests, and so is what it has started.
    std::signal(SIGTERM, SIG_IGN);
    if (fork() < 0) return 1;
    for (;;) pause();
  }
  if (solver_is("ceres_lbfgs"))
    for (std::vector<char*> taken;;) {
      constexpr std::size_t block = 4 << 20;
      taken.push_back(new char[block]);
      std::memset(taken.back(), 1, block);
      usleep(200);
    }
  if (solver_is("nlopt_lbfgs")) return 9;
  if (solver_is("nlopt_mma")) return 0;
  if (solver_is("fletcher_reeves")) {
    std::fputs("shellmatch: error: out/history.csv: cannot be written (No space left on device); make room\n", stderr);
    return 6;
  }
  execv(SHELLMATCH_PROGRAM, argv);
  return 127;
}
