#pragma once

#include <scree/mpm/transfers/aflip.hpp>
#include <scree/mpm/transfers/apic.hpp>
#include <scree/mpm/transfers/pic_flip.hpp>
#include <scree/mpm/transfers/tpic.hpp>

#include <variant>

namespace scree::mpm {

/// Every transfer. A new one is a line here, its header and its test.
using AnyTransfer = std::variant<Aflip, Apic, PicFlip, Tpic>;

}  // namespace scree::mpm
