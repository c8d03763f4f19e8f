#include "matching/experiment/several_errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace shellmatch {

SeveralInputErrors::SeveralInputErrors(std::vector<std::string> texts)
    : InputError(fmt::format("{}", fmt::join(texts, "; "))), texts_(std::move(texts)) {}

}  // namespace shellmatch
