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

// Hashes of the program's results, kept in a file beside the test: what must stay the same, byte for byte,
// when the code is rearranged.
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

// Compares the hashes of one preset, by name (each begins with the preset's and a space), with those in the
// file. If CAROM_WRITE_GOLDEN is set, writes them into the file instead.
inline void expect_golden(const std::filesystem::path& file, const std::string& preset,
                          const std::map<std::string, std::string>& now) {
  const char* const functions = "functions";
  std::map<std::string, std::string> all;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t space = line.rfind(' ');
    if (space != std::string::npos) all[line.substr(0, space)] = line.substr(space + 1);
  }
  if (std::getenv("CAROM_WRITE_GOLDEN") != nullptr) {
    std::erase_if(all, [&](const auto& entry) { return entry.first.starts_with(preset + " "); });
    all.insert(now.begin(), now.end());
    all[functions] = hash_of_functions();
    std::ofstream out(file);
    for (const auto& [name, hash] : all) out << name << ' ' << hash << '\n';
    return;
  }
  if (all[functions] != hash_of_functions())
    GTEST_SKIP() << "sin, exp and the like differ in their last bits here";
  for (const auto& [name, hash] : now) EXPECT_EQ(all[name], hash) << name;
}

}  // namespace carom::test
