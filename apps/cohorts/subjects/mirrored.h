#pragma once
/// \file
/// Subjects that are reflected before they are matched: left shapes among right ones.

#include "apps/cohorts/subjects/subject.h"
#include "matching/experiment/options.h"

#include <string>

namespace shellmatch {

/// Writes the subject's shape with -x in place of x into `folder`, as ID.ply or ID.csv, and returns that
/// file. Where the shape cannot be read, the subject's own file, of which the matching will say what is
/// wrong.
std::string mirrored_shape(const Subject& subject, const InputOptions& input, const std::string& folder);

/// The same of its landmarks, as ID_landmarks.csv. \pre the subject has some
std::string mirrored_landmarks(const Subject& subject, const InputOptions& input, const std::string& folder);

/// The frame in which `input` asks for shapes out of volumes.
Space volume_space(const InputOptions& input);

}  // namespace shellmatch
