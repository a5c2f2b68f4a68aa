#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

namespace carom::fuzz {

// Random bytes taken from the end as values; what is left in front is the rest. No bytes left give zeros.
class Values {
 public:
  explicit Values(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::string_view rest() const { return bytes_; }

  std::uint64_t bits() {
    std::uint64_t value = 0;
    const std::size_t count = bytes_.size() < sizeof value ? bytes_.size() : sizeof value;
    std::memcpy(&value, bytes_.data() + (bytes_.size() - count), count);
    bytes_.remove_suffix(count);
    return value;
  }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const char last = bytes_.back();
    bytes_.remove_suffix(1);
    return static_cast<std::uint8_t>(last);
  }
  // 0 .. count - 1, count up to 256.
  int below(int count) { return byte() % count; }
  // Uniform over the bits' top 53: low to high.
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }

 private:
  std::string_view bytes_;
};

}  // namespace carom::fuzz
