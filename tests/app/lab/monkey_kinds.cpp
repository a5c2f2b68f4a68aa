#include "monkey.h"

namespace carom {

// The weights say how often each is done.
const std::vector<Monkey::Kind>& Monkey::kinds() {
  static const std::vector<Kind> table = {
      {"move", 14, &Monkey::move},
      {"click", 22, &Monkey::click},
      {"double click", 4, &Monkey::double_click},
      {"right click", 6, &Monkey::right_click},
      {"middle click", 3, &Monkey::middle_click},
      {"press", 2, &Monkey::press_only},
      {"drag", 8, &Monkey::drag},
      {"wheel", 6, &Monkey::wheel},
      {"key", 10, &Monkey::key},
      {"type", 3, &Monkey::type},
      {"shortcut", 6, &Monkey::shortcut},
      {"menu", 6, &Monkey::menu},
      {"button", 5, &Monkey::button},
      {"answer", 8, &Monkey::answer},
      {"experiment", 4, &Monkey::experiment},
      {"open", 2, &Monkey::open_file},
      {"drop", 2, &Monkey::drop},
      {"resize", 3, &Monkey::resize},
      {"close", 1, &Monkey::close_top},
      {"clipboard", 1, &Monkey::clipboard},
      {"play", 5, &Monkey::play},
      {"rest", 3, &Monkey::rest},
      {"draw", 14, &Monkey::draw},
      {"cell", 5, &Monkey::cell},
      {"slider", 5, &Monkey::slider},
      {"link", 4, &Monkey::link},
      {"edit key", 6, &Monkey::edit_key},
      {"take back", 6, &Monkey::take_back},
      {"fold", 2, &Monkey::fold},
      {"scrub", 6, &Monkey::scrub},
      {"new", 1, &Monkey::new_scene},
      {"pull", 6, &Monkey::pull},
      {"stop", 3, &Monkey::stop},
      {"start", 3, &Monkey::start},
  };
  return table;
}

}  // namespace carom
