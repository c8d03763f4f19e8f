#pragma once
/// \file
/// VTK's XML files: a data set in pieces, each with sections of arrays.

#include "base/error.h"
#include "geometry/surface/space.h"
#include "geometry/vtk_xml/xml_array.h"
#include "geometry/vtk_xml/xml_head.h"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

struct XmlPiece {
  XmlTag tag;  ///< <Piece ...>
  std::map<std::string, std::vector<XmlArray>, std::less<>>
      sections;  ///< "Points", "PointData", ...; "" for those in no section
};

/// What a reader wants of a file.
struct XmlExpectation {
  std::string_view type;          ///< "PolyData"
  std::string_view what;          ///< "VTK file of polygonal data", for messages
  std::string_view advice;        ///< for files of another type
  std::string_view instead = "";  ///< for damaged files: "; give another"
};

/// The file is damaged or cut off; the text says of what kind it should be.
class DamagedXmlFile : public InputError {
 public:
  using InputError::InputError;
};

/// The head of a file, and where its values are. The bytes outlive it.
class VtkXmlFile {
 public:
  /// \throws DamagedXmlFile, or another InputError where the file is of another type, or compressed otherwise than by
  /// zlib
  VtkXmlFile(const std::string& path, std::string_view bytes, const XmlExpectation& expected);

  const std::vector<XmlPiece>& pieces() const { return pieces_; }
  /// The arrays of numbers of the whole, in the section "FieldData".
  const XmlPiece& facts() const { return facts_; }
  /// <PolyData ...>, <ImageData ...>
  const XmlTag& data_set() const { return data_set_; }
  /// What 3D Slicer has written of the frame.
  Space space() const { return space_; }

  /// A whole number >= 0 of a tag. \param otherwise where it has none
  std::size_t number(const XmlTag& tag, std::string_view key, std::size_t otherwise) const;
  /// The array of that name, or the first for ""; null where there is none.
  static const XmlArray* find(const XmlPiece& piece, std::string_view section, std::string_view name);
  /// n numbers. \throws InputError as xml_values
  std::vector<double> values(const XmlArray& array, std::size_t n) const {
    return xml_values(path_, array, encoding_, n);
  }

  /// Arrays of points whose type has no numbers: "point data 'name' of type String dropped".
  const std::vector<std::string>& dropped() const { return dropped_; }
  /// \throws DamagedXmlFile
  [[noreturn]] void damaged(std::string_view why) const;

  /// Components that an array may have.
  static constexpr std::size_t max_components = 1000;

 private:
  struct Appended {
    std::optional<std::size_t> piece;  // none: of facts_
    std::size_t offset;
    std::string section;
    std::size_t index;
  };
  void read_tags();
  void read_root(const XmlTag& tag);
  void read_array(const XmlTag& tag, std::string_view section);
  void read_space(XmlArray array, const XmlTag& tag);
  void set_space(const XmlArray& array);
  void take_appended();
  std::string_view text_within(std::string_view name) const;

  const std::string& path_;
  std::string_view rest_;
  XmlExpectation expected_;
  XmlEncoding encoding_;
  XmlTag data_set_;
  std::vector<XmlPiece> pieces_;
  XmlPiece facts_;
  std::vector<Appended> appended_;
  std::size_t n_arrays_ = 0;
  Space space_ = Space::unsaid;
  std::optional<XmlArray> space_array_;  // where it is appended
  std::size_t space_offset_ = 0;
  std::vector<std::string> dropped_;
};

}  // namespace shellmatch
