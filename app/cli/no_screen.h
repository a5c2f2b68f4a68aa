#pragma once

namespace carom {

// Call before creating an application that only draws pictures: it then needs no display and prints no warning
// about it.
void use_no_screen();

}  // namespace carom
