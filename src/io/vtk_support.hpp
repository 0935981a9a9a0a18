#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLReader.h>
#include <vtkXMLWriter.h>

class vtkCallbackCommand;
class vtkObject;

namespace eisph {

/// Collects the errors of VTK objects, which they would print otherwise.
class VtkErrors {
 public:
  VtkErrors();
  VtkErrors(const VtkErrors&) = delete;
  VtkErrors& operator=(const VtkErrors&) = delete;
  ~VtkErrors();

  void watch(vtkObject* object);
  /// Watches the reader, its parser and its executive.
  void watch_reader(vtkXMLReader* reader);
  [[nodiscard]] bool empty() const { return text_.empty(); }
  /// What went wrong first.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  vtkNew<vtkCallbackCommand> callback_;
  std::string text_;
};

/// Runs the writer in binary mode with LZ4 and puts the file in place. Throws std::runtime_error.
void write_atomically(vtkXMLWriter* writer, const std::filesystem::path& path);

/// Runs the reader. Throws InputError if the file is missing, cut short or damaged.
void read_completely(vtkXMLReader* reader, const std::filesystem::path& path);

/// A VTK array over values that someone else owns and VTK only reads.
template <typename Array, typename Value>
vtkSmartPointer<Array> borrow_array(const char* name, const Value* values, std::size_t count,
                                    int components) {
  using Element = typename Array::ValueType;
  static_assert(sizeof(Value) % sizeof(Element) == 0);
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  // VTK has no arrays of constants; the flag 1 makes it leave the memory to its owner.
  auto* elements = const_cast<Element*>(reinterpret_cast<const Element*>(values));
  array->SetArray(elements, static_cast<vtkIdType>(count) * components, 1);
  return array;
}

void put_field(vtkFieldData* fields, const char* name, double value);
void put_field(vtkFieldData* fields, const char* name, std::uint64_t value);

/// Copies the values of `array`, which may be null, into `values`, which has the size wanted. Throws
/// InputError with the path if the array has another type, number of components or size.
void copy_values(const std::filesystem::path& path, const char* name, vtkDataArray* array, bool floating,
                 std::size_t element_size, int components, std::size_t count, void* values);

template <typename Element, typename Value>
void take_array(const std::filesystem::path& path, const char* name, vtkDataArray* array,
                std::vector<Value>& values) {
  constexpr std::size_t kElementSize = sizeof(Element);
  constexpr std::size_t kValueSize = sizeof(Value);
  static_assert(std::is_arithmetic_v<Element> && kValueSize % kElementSize == 0);
  copy_values(path, name, array, std::is_floating_point_v<Element>, kElementSize,
              static_cast<int>(kValueSize / kElementSize), values.size(), values.data());
}

[[nodiscard]] double take_double(const std::filesystem::path& path, vtkFieldData* fields, const char* name);
[[nodiscard]] std::uint64_t take_uint64(const std::filesystem::path& path, vtkFieldData* fields,
                                        const char* name);

}  // namespace eisph
