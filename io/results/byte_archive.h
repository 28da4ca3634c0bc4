// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/check.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

// Values as bytes without loss, as they lie in memory. A struct has a function fields(archive,
// struct) in the namespace of the archives, which names its fields once for both directions.

namespace ridgeline::results {

template <typename T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Writes or reads a value: by the archive itself, or its fields one by one.
template <typename Archive, typename Value>
void each(Archive& archive, Value& value) {
  if constexpr (requires { archive(value); }) {
    archive(value);
  } else {
    fields(archive, value);
  }
}

/// Writes or reads values one after the other.
void all(auto& archive, auto&... values) { (each(archive, values), ...); }

/// Writes values one behind the other.
class ByteWriter {
 public:
  template <Number T>
  void operator()(const T& number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  void operator()(const std::string& text) {
    (*this)(std::uint64_t{text.size()});
    bytes_ += text;
  }
  template <int kRows, int kColumns>
  void operator()(const Eigen::Matrix<double, kRows, kColumns>& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) (*this)(matrix.data()[i]);
  }
  template <typename T>
  void operator()(const std::optional<T>& value) {
    (*this)(value.has_value());
    if (value) each(*this, *value);
  }
  template <typename T>
  void operator()(const std::vector<T>& values) {
    (*this)(std::uint64_t{values.size()});
    for (const T& value : values) each(*this, value);
  }
  template <typename T, std::size_t kSize>
  void operator()(const std::array<T, kSize>& values) {
    for (const T& value : values) each(*this, value);
  }

  /// Writes lists of keys of points, most of which planes beside each other share. A key that was
  /// there before takes a byte or few: its place among all keys, against the place of the key
  /// before it.
  void key_lists(const std::vector<std::vector<std::uint64_t>>& lists) {
    (*this)(std::uint64_t{lists.size()});
    for (const auto& keys : lists) key_list(keys);
  }

  std::string take() { return std::move(bytes_); }

 private:
  void key_list(const std::vector<std::uint64_t>& keys) {
    (*this)(std::uint64_t{keys.size()});
    std::uint64_t expected = 0;
    for (const std::uint64_t key : keys) {
      const auto [known, is_new] = places_.emplace(key, places_.size());
      if (is_new) {
        varint(0);
        (*this)(key);
      } else {
        varint(1 + zigzag(known->second - expected));
      }
      expected = known->second + 1;
    }
  }

  /// 0, -1, 1, -2, 2 ... as 0, 1, 2, 3, 4 ...; differences are those of unsigned numbers.
  static std::uint64_t zigzag(std::uint64_t difference) {
    return (difference << 1U) ^ ((difference >> 63U) != 0 ? ~std::uint64_t{0} : 0);
  }
  /// Seven bits a byte, the lowest first.
  void varint(std::uint64_t number) {
    constexpr std::uint64_t kMore = 0x80;
    for (; number >= kMore; number >>= 7U) bytes_ += static_cast<char>((number & 0x7fU) | kMore);
    bytes_ += static_cast<char>(number);
  }

  std::string bytes_;
  std::unordered_map<std::uint64_t, std::uint64_t> places_;  ///< of the keys, in their order
};

/// Reads what a ByteWriter wrote. Throws std::invalid_argument for other bytes.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <Number T>
  void operator()(T& number) {
    std::memcpy(&number, take(sizeof number).data(), sizeof number);
  }
  void operator()(std::string& text) { text = take(count()); }
  void operator()(bool& value) {
    std::uint8_t byte = 0;
    (*this)(byte);
    value = byte != 0;
  }
  template <int kRows, int kColumns>
  void operator()(Eigen::Matrix<double, kRows, kColumns>& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) (*this)(matrix.data()[i]);
  }
  template <typename T>
  void operator()(std::optional<T>& value) {
    std::uint8_t has_value = 0;
    (*this)(has_value);
    value.reset();
    if (has_value != 0) each(*this, value.emplace());
  }
  template <typename T>
  void operator()(std::vector<T>& values) {
    values.resize(count());
    for (T& value : values) each(*this, value);
  }
  template <typename T, std::size_t kSize>
  void operator()(std::array<T, kSize>& values) {
    for (T& value : values) each(*this, value);
  }

  /// Reads what ByteWriter::key_lists() wrote.
  void key_lists(std::vector<std::vector<std::uint64_t>>& lists) {
    lists.resize(count());
    for (auto& keys : lists) key_list(keys);
  }

  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

 private:
  void key_list(std::vector<std::uint64_t>& keys) {
    keys.resize(count());
    std::uint64_t expected = 0;
    for (std::uint64_t& key : keys) {
      const std::uint64_t code = varint();
      const std::uint64_t place = code == 0 ? keys_.size() : expected + unzigzag(code - 1);
      if (code == 0) (*this)(keys_.emplace_back());
      check(place < keys_.size(), "part: key ", place, " of ", keys_.size(),
            ", must be one of them");
      key = keys_[place];
      expected = place + 1;
    }
  }

  /// The number of elements that follow. Each takes a byte at least, so that damage asks for no
  /// absurd memory.
  std::size_t count() {
    std::uint64_t n = 0;
    (*this)(n);
    check(n <= bytes_.size(), "part: ", n, " elements in ", bytes_.size(),
          " bytes; must be no more");
    return n;
  }
  std::string_view take(std::size_t n) {
    check(n <= bytes_.size(), "part: ", bytes_.size(), " bytes left, must be at least ", n);
    const std::string_view front = bytes_.substr(0, n);
    bytes_.remove_prefix(n);
    return front;
  }

  static std::uint64_t unzigzag(std::uint64_t number) {
    return (number >> 1U) ^ ((number & 1U) != 0 ? ~std::uint64_t{0} : 0);
  }
  std::uint64_t varint() {
    constexpr unsigned kMaxShift = 63;
    std::uint64_t number = 0;
    for (unsigned shift = 0;; shift += 7) {
      check(shift <= kMaxShift, "part: a number of more than 64 bits, must be no more");
      std::uint8_t byte = 0;
      (*this)(byte);
      number |= std::uint64_t{byte & 0x7fU} << shift;
      if ((byte & 0x80U) == 0) return number;
    }
  }

  std::string_view bytes_;
  std::vector<std::uint64_t> keys_;  ///< in their order
};

/// The type `T`, to be written, or without const to be read.
template <typename Value, typename T>
concept Some = std::is_same_v<std::remove_const_t<Value>, T>;

}  // namespace ridgeline::results
