#include "base/error.h"
#include "base/instantiate.h"
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

template <class S, class T>
concept Is = std::is_same_v<std::remove_const_t<S>, T>;
template <class S, template <int> class T>
concept IsOfDim = Is<S, T<2>> || Is<S, T<3>>;

template <class S, class Member>
requires IsOfDim<S, Start>
static void describe(S& s, Member&& member) {
  member("pose", s.alignment.pose);
  member("pairs", s.alignment.pairs);
  member("spread", s.alignment.spread);
  member("landmark_trust", s.alignment.landmark_trust);
  member("found", s.n_pairs);
  member("contradicting", s.n_contradicting);
  member("score", s.score);
  member("order", s.order);
  member("landmark_distance", s.landmark_distance);
  member("identity", s.is_identity);
  member("mirrored", s.is_mirrored);
}

template <class S, class Member>
requires IsOfDim<S, StartSearch>
static void describe(S& s, Member&& member) {
  member("starts", s.starts);
  member("margin", s.margin);
  member("share", s.searched_share);
  member("landmarks", s.n_landmarks);
  member("landmarks_are_spread", s.landmarks_are_spread);
  member("notes", s.notes);
  member("part", s.is_of_part);
  member("ambiguous", s.is_ambiguous);
}

template <Is<Trial> S, class Member>
static void describe(S& s, Member&& member) {
  member("energy", s.energy);
  member("with_pairs", s.with_pairs);
  member("template_distance", s.template_distance);
  member("spin_difference", s.spin_difference);
}

template <Is<DirectionTrial> S, class Member>
static void describe(S& s, Member&& member) {
  member("distance", s.distance);
  member("energy", s.energy);
  member("missed", s.missed);
}

template <class S, class Member>
requires requires(S& s) {
  s.results;
  s.seconds;
}
static void describe(S& s, Member&& member) {
  member("results", s.results);
  member("seconds", s.seconds);
}

template <class S, class Member>
requires IsOfDim<S, AlignmentFindings>
static void describe(S& s, Member&& member) {
  member("by_pairs", s.by_pairs);
  member("by_poses", s.by_poses);
  member("fits_mirrored", s.fits_mirrored);
  member("starts", s.trials.starts);
  member("directions", s.trials.directions);
}

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
