#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <string_view>

// The program's results, kept in a file beside the test: what must stay the same, byte for byte, when the code
// is rearranged. sin, exp and the like are not rounded alike everywhere: there results are compared more
// loosely.
namespace carom::test {

// Fowler, Noll and Vo's hash, 64 bits, FNV-1a.
class Hash {
 public:
  void add(double value) {
    auto bits = std::bit_cast<std::uint64_t>(value);
    for (int k = 0; k < 8; ++k, bits >>= 8) add_byte(static_cast<unsigned char>(bits & 0xFFU));
  }
  void add(std::string_view text) {
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
  }
  template <class Matrix>
  void add_all(const Matrix& m) {
    for (Eigen::Index i = 0; i < m.size(); ++i) add(m.data()[i]);
  }
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  void add_byte(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001B3U; }
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

// Results of the machine's mathematical functions, which no standard fixes to the last bit.
inline std::string hash_of_functions() {
  Hash hash;
  for (int k = 1; k <= 2000; ++k) {
    const double x = 0.0137 * k;
    for (const double y : {std::sin(x), std::cos(x), std::sin(1e3 * x), std::atan2(x, 2.0), std::hypot(x, 1.1),
                           std::exp(-x), std::log(x), std::pow(x, 0.2), std::cbrt(x)}) {
      hash.add(y);
    }
  }
  return hash.text();
}

// What a golden file keeps of one result: a hash of all its bytes; and a text that tells the same of it where
// mathematical functions round differently.
struct Golden {
  std::string hash;
  std::string loose;
};

// The results in a file, by name: one a line, its parts separated by tabs.
inline std::map<std::string, Golden> read_golden(const std::filesystem::path& file) {
  std::map<std::string, Golden> all;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find('\t');
    const std::size_t second = line.find('\t', first + 1);
    if (second != std::string::npos)
      all[line.substr(0, first)] = {line.substr(first + 1, second - first - 1), line.substr(second + 1)};
  }
  return all;
}

// Compares the results of one preset, by name (each begins with the preset's and a space), with those in the
// file: by their hashes, or, where mathematical functions round differently, by `compare_loosely(name, loose)`.
// If CAROM_WRITE_GOLDEN is set, writes them into the file instead, with `loose_of(name)`.
template <class LooseOf, class CompareLoosely>
void expect_golden(const std::filesystem::path& file, const std::string& preset,
                   const std::map<std::string, std::string>& hashes, const LooseOf& loose_of,
                   const CompareLoosely& compare_loosely) {
  const char* const functions = "functions";
  std::map<std::string, Golden> all = read_golden(file);
  if (std::getenv("CAROM_WRITE_GOLDEN") != nullptr) {
    std::erase_if(all, [&](const auto& entry) { return entry.first.starts_with(preset + " "); });
    for (const auto& [name, hash] : hashes) all[name] = {hash, loose_of(name)};
    all[functions] = {hash_of_functions(), ""};
    std::ofstream out(file);
    for (const auto& [name, golden] : all) out << name << '\t' << golden.hash << '\t' << golden.loose << '\n';
    return;
  }
  const bool same_functions = all[functions].hash == hash_of_functions();
  for (const auto& [name, hash] : hashes) {
    ASSERT_TRUE(all.contains(name)) << name << " is not in " << file;
    if (same_functions) {
      EXPECT_EQ(all[name].hash, hash) << name;
    } else {
      compare_loosely(name, all[name].loose);
    }
  }
}

}  // namespace carom::test
