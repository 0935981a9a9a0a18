#include "io/vtk_support.hpp"

#include "core/error.hpp"
#include "io/file_io.hpp"

#include <cstring>
#include <exception>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkTypeUInt64Array.h>

namespace eisph {

namespace {

/// The message alone out of VTK's "ERROR: In <source>, line <n>\n<class> (<address>): <message>\n\n".
std::string message_of(std::string_view report) {
  const std::size_t start = report.find("): ");
  if (start != std::string_view::npos) report.remove_prefix(start + 3);
  while (!report.empty() && (report.back() == '\n' || report.back() == ' ')) report.remove_suffix(1);
  return std::string(report);
}

void keep_first(vtkObject* /*caller*/, unsigned long /*event*/, void* client, void* data) {
  auto* text = static_cast<std::string*>(client);
  if (text != nullptr && text->empty() && data != nullptr) *text = message_of(static_cast<const char*>(data));
}

std::string failure_of(const VtkErrors& errors, unsigned long code) {
  if (code == vtkErrorCode::OutOfDiskSpaceError) return "no space left on the device";
  return errors.empty() ? fmt::format("VTK's error {}", code) : errors.text();
}

/// Whether the file goes on to the end of its XML.
bool is_complete(const std::filesystem::path& path) {
  constexpr std::string_view kEnd = "</VTKFile>";
  const std::string content = read_file(path);
  const std::size_t last = content.find_last_not_of(" \t\r\n");
  return last != std::string::npos && std::string_view(content).substr(0, last + 1).ends_with(kEnd);
}

std::string described(bool floating, std::size_t element_size, int components, std::size_t count) {
  return fmt::format("{} x {} {}-bit {}", count, components, 8 * element_size,
                     floating ? "floats" : "integers");
}

}  // namespace

VtkErrors::VtkErrors() {
  callback_->SetCallback(keep_first);
  callback_->SetClientData(&text_);
}

// The objects that were watched may outlive the text.
VtkErrors::~VtkErrors() { callback_->SetClientData(nullptr); }

void VtkErrors::watch(vtkObject* object) {
  object->AddObserver(vtkCommand::ErrorEvent, callback_);
  object->AddObserver(vtkCommand::WarningEvent, callback_);
}

void VtkErrors::watch_reader(vtkXMLReader* reader) {
  watch(reader);
  watch(reader->GetExecutive());
  reader->SetParserErrorObserver(callback_);
}

void write_atomically(vtkXMLWriter* writer, const std::filesystem::path& path) {
  VtkErrors errors;
  errors.watch(writer);
  errors.watch(writer->GetExecutive());
  AtomicFile atomic(path);
  OutputFile(atomic.temporary_path()).close();  // says why a file cannot be made, which VTK does not
  writer->SetFileName(atomic.temporary_path().c_str());
  writer->SetDataModeToAppended();
  writer->SetEncodeAppendedData(0);
  writer->SetHeaderTypeToUInt64();
  writer->SetCompressorTypeToLZ4();
  const bool written = writer->Write() == 1;
  if (!written || !errors.empty() || writer->GetErrorCode() != vtkErrorCode::NoError) {
    throw std::runtime_error(
        fmt::format("{}: cannot be written: {}", path.string(), failure_of(errors, writer->GetErrorCode())));
  }
  atomic.commit();
}

void read_completely(vtkXMLReader* reader, const std::filesystem::path& path) {
  if (!is_complete(path)) {
    throw InputError(
        fmt::format("{}: is cut short or no VTK file: it does not end with </VTKFile>", path.string()));
  }
  VtkErrors errors;
  errors.watch_reader(reader);
  reader->SetFileName(path.c_str());
  try {
    reader->Update();
  } catch (const std::exception& error) {
    // Out of a damaged block VTK may read any size, and ask for that much memory.
    throw InputError(fmt::format("{}: is damaged: {}", path.string(), error.what()));
  }
  if (!errors.empty() || reader->GetErrorCode() != vtkErrorCode::NoError) {
    throw InputError(
        fmt::format("{}: cannot be read: {}", path.string(), failure_of(errors, reader->GetErrorCode())));
  }
}

void put_field(vtkFieldData* fields, const char* name, double value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fields->AddArray(array);
}

void put_field(vtkFieldData* fields, const char* name, std::uint64_t value) {
  vtkNew<vtkTypeUInt64Array> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fields->AddArray(array);
}

void copy_values(const std::filesystem::path& path, const char* name, vtkDataArray* array, bool floating,
                 std::size_t element_size, int components, std::size_t count, void* values) {
  if (array == nullptr) {
    throw InputError(fmt::format("{}: has no array '{}' ({})", path.string(), name,
                                 described(floating, element_size, components, count)));
  }
  const int type = array->GetDataType();
  const bool is_floating = type == VTK_FLOAT || type == VTK_DOUBLE;
  const auto found_size = static_cast<std::size_t>(array->GetDataTypeSize());
  const auto found_count = static_cast<std::size_t>(array->GetNumberOfTuples());
  if (is_floating != floating || found_size != element_size || array->GetNumberOfComponents() != components ||
      found_count != count) {
    throw InputError(
        fmt::format("{}: array '{}' has {}, not {}", path.string(), name,
                    described(is_floating, found_size, array->GetNumberOfComponents(), found_count),
                    described(floating, element_size, components, count)));
  }
  if (count > 0) std::memcpy(values, array->GetVoidPointer(0), count * components * element_size);
}

double take_double(const std::filesystem::path& path, vtkFieldData* fields, const char* name) {
  std::vector<double> value(1);
  take_array<double>(path, name, fields->GetArray(name), value);
  return value.front();
}

std::uint64_t take_uint64(const std::filesystem::path& path, vtkFieldData* fields, const char* name) {
  std::vector<std::uint64_t> value(1);
  take_array<std::uint64_t>(path, name, fields->GetArray(name), value);
  return value.front();
}

}  // namespace eisph
