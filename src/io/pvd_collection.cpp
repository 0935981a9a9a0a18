#include "io/pvd_collection.hpp"

#include "core/error.hpp"
#include "io/file_io.hpp"
#include "io/vtk_support.hpp"

#include <charconv>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

namespace eisph {

namespace {

/// As the value of an XML attribute.
std::string escaped(const std::string& text) {
  std::string value;
  for (const char character : text) {
    switch (character) {
      case '&':
        value += "&amp;";
        break;
      case '<':
        value += "&lt;";
        break;
      case '>':
        value += "&gt;";
        break;
      case '"':
        value += "&quot;";
        break;
      default:
        value += character;
    }
  }
  return value;
}

[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view what) {
  throw InputError(fmt::format("{}: is no ParaView collection: {}", path.string(), what));
}

PvdEntry entry_of(const std::filesystem::path& path, vtkXMLDataElement* data_set) {
  const char* time = data_set->GetAttribute("timestep");
  const char* file = data_set->GetAttribute("file");
  if (time == nullptr || file == nullptr) refuse(path, "a DataSet has no timestep or no file");
  PvdEntry entry;
  const char* end = time + std::strlen(time);
  const auto [stop, error] = std::from_chars(time, end, entry.time);
  if (error != std::errc() || stop != end)
    refuse(path, fmt::format("timestep = '{}': must be a number", time));
  entry.file = path.parent_path() / file;
  return entry;
}

}  // namespace

PvdCollection::PvdCollection(std::filesystem::path path) : path_(std::move(path)) {}

void PvdCollection::add(double time, const std::filesystem::path& file) {
  const std::filesystem::path folder = std::filesystem::absolute(path_).parent_path();
  entries_.push_back({time, std::filesystem::absolute(file).lexically_relative(folder)});
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const PvdEntry& entry : entries_) {
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", entry.time,
                        escaped(entry.file.generic_string()));
  }
  text += "  </Collection>\n</VTKFile>\n";
  write_file_atomically(path_, text);
}

std::vector<PvdEntry> read_pvd(const std::filesystem::path& path) {
  std::istringstream text(read_file(path));
  VtkErrors errors;
  const vtkNew<vtkXMLDataParser> parser;
  errors.watch(parser);
  parser->SetStream(&text);
  const bool parsed = parser->Parse() == 1;
  if (!parsed || !errors.empty()) refuse(path, errors.text());
  vtkXMLDataElement* root = parser->GetRootElement();
  vtkXMLDataElement* collection = root == nullptr ? nullptr : root->FindNestedElementWithName("Collection");
  if (collection == nullptr) refuse(path, "it has no element Collection");

  std::vector<PvdEntry> entries;
  for (int k = 0; k < collection->GetNumberOfNestedElements(); ++k) {
    vtkXMLDataElement* element = collection->GetNestedElement(k);
    if (std::string_view(element->GetName()) == "DataSet") entries.push_back(entry_of(path, element));
  }
  return entries;
}

}  // namespace eisph
