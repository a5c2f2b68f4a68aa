#include "physics/files/output_set.h"

#include <fmt/format.h>
#include <unistd.h>

#include "physics/scene/validate.h"

namespace carom {

OutputSet::OutputSet(const std::vector<std::filesystem::path>& inputs) {
  for (const std::filesystem::path& name : inputs) {
    struct stat facts = {};
    if (stat(name.c_str(), &facts) == 0 && !S_ISCHR(facts.st_mode))
      inputs_.emplace(id_of(facts), name.string());
  }
}

OutputPlace OutputSet::reserve(const std::string& name) {
  using Kind = OutputPlace::Kind;
  OutputPlace place = output_place(name);
  const bool there = place.kind != Kind::kNew;
  if (there && S_ISCHR(place.facts.st_mode)) return place;
  const FileId id = id_of(place.facts);
  if (const auto input = inputs_.find(id); there && input != inputs_.end())
    refuse_output(name, fmt::format("this is the file that is read, {}", input->second), "another file");
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat facts = {};
    if (place.kind == Kind::kReplaced && fstat(stream, &facts) == 0 && id_of(facts) == id)
      refuse_output(name, stream == STDOUT_FILENO ? "stdout goes to this file" : "stderr goes to this file",
                    "another file");
  }
  const auto refuse_twice = [&](const std::string& other) {
    refuse_output(name, fmt::format("the output {} goes to this file too", other), "a file for each");
  };
  if (there) {
    const auto [other, first] = outputs_.emplace(id, name);
    if (!first) refuse_twice(other->second);
  } else {
    const auto [other, first] =
        new_outputs_.emplace(std::pair(place.folder, place.file.filename().string()), name);
    if (!first) refuse_twice(other->second);
  }
  return place;
}

OutputFile* OutputSet::open(const std::string& name) {
  return name.empty() ? nullptr : &files_.emplace_back(reserve(name));
}

std::string OutputSet::commit() {
  std::string failures;
  for (OutputFile& file : files_) {
    try {
      file.commit();
    } catch (const SceneError& error) {
      failures += (failures.empty() ? "" : "; ") + std::string(error.what());
    }
  }
  return failures;
}

}  // namespace carom
