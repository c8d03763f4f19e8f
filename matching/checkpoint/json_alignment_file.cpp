#include "base/error.h"
#include "matching/checkpoint/alignment_file.h"
#include "matching/json/json_members.h"
#include "matching/output/write_file.h"

#include <fstream>
#include <iterator>
#include <type_traits>
#include <vector>

namespace shellmatch {

namespace {

template <class Numbers>
void append(std::vector<double>& to, const Numbers& numbers) {
  to.insert(to.end(), numbers.data(), numbers.data() + numbers.size());
}

[[noreturn]] void refuse(const char* what) { throw_input_error("{} are not those of these shapes", what); }

constexpr std::size_t pose_size(std::size_t dim) { return 1 + dim + dim * dim; }
constexpr std::size_t pair_size(std::size_t dim) { return 2 * dim + 1; }

}  // namespace

// Scale, offset, rotation by columns.
template <int Dim>
static std::vector<double> packed(const Similarity<Dim>& pose) {
  std::vector<double> numbers{pose.scale};
  append(numbers, pose.offset);
  append(numbers, pose.rotation);
  return numbers;
}

template <int Dim>
static void unpack(const std::vector<double>& numbers, Similarity<Dim>& pose) {
  if (numbers.size() != pose_size(Dim)) refuse("poses");
  pose = {numbers[0], Eigen::Map<const Vec<Dim>>(&numbers[1]), Eigen::Map<const Mat<Dim>>(&numbers[1 + Dim])};
}

// Of each pair both points and the weight.
template <int Dim>
static std::vector<double> packed(const std::vector<Landmark<Dim>>& pairs) {
  std::vector<double> numbers;
  numbers.reserve(pair_size(Dim) * pairs.size());
  for (const Landmark<Dim>& pair : pairs) {
    append(numbers, pair.on_reference);
    append(numbers, pair.on_template);
    numbers.push_back(pair.weight);
  }
  return numbers;
}

template <int Dim>
static void unpack(const std::vector<double>& numbers, std::vector<Landmark<Dim>>& pairs) {
  if (numbers.size() % pair_size(Dim) != 0) refuse("pairs");
  for (std::size_t at = 0; at < numbers.size(); at += pair_size(Dim))
    pairs.push_back({pair_name(pairs.size()), Eigen::Map<const Vec<Dim>>(&numbers[at]),
                     Eigen::Map<const Vec<Dim>>(&numbers[at + Dim]), numbers[at + 2 * Dim]});
}

SHELLMATCH_JSON_2D_3D(Start, (alignment.pose, pose), (alignment.pairs, pairs), (alignment.spread, spread),
                      (alignment.landmark_trust, landmark_trust), (alignment.is_of_part, part), (n_pairs, found),
                      (n_contradicting, contradicting), pair_share, score, order, margin, landmark_distance,
                      (is_identity, identity), (is_mirrored, mirrored))
SHELLMATCH_JSON_2D_3D(StartSearch, starts, margin, reference_share, template_share, (n_landmarks, landmarks),
                      landmarks_are_spread, notes, (is_of_part, part), (is_ambiguous, ambiguous), mirrored_gain)
SHELLMATCH_JSON(Trial, energy, with_pairs, template_distance, spin_difference, limb_disorder)
SHELLMATCH_JSON(DirectionTrial, distance, energy, missed, limb_disorder)
SHELLMATCH_JSON_IF((requires(S & s) { s.results, s.seconds; }), results, seconds)
SHELLMATCH_JSON_2D_3D(AlignmentFindings, by_pairs, by_poses, fits_mirrored, (trials.starts, starts),
                      (trials.directions, directions))

template <int Dim>
void write_alignment(const AlignmentFindings<Dim>& findings, const std::string& path) {
  write_file(path, json_bytes(json_of(findings)));
}

template <int Dim>
AlignmentFindings<Dim> read_alignment(const std::string& path) {
  AlignmentFindings<Dim> findings;
  try {
    std::ifstream in(path, std::ios::binary);
    set_from_json(parse_json_bytes({std::istreambuf_iterator<char>(in), {}}), findings);
  } catch (const Json::exception& error) {
    throw_input_error("{}: {}", path, error.what());
  } catch (const InputError& error) {
    throw_input_error("{}: {}", path, error.what());
  }
  for (const auto* searches : {&findings.by_pairs, &findings.by_poses})
    for (const StartSearch<Dim>& search : searches->results) {
      if (search.starts.empty()) throw_input_error("{}: a search without starts", path);
      for (const Start<Dim>& start : search.starts)
        if (start.n_contradicting > start.alignment.pairs.size())
          throw_input_error("{}: more pairs contradict than there are", path);
    }
  return findings;
}

SHELLMATCH_2D_3D(write_alignment);
SHELLMATCH_2D_3D(read_alignment);

}  // namespace shellmatch
