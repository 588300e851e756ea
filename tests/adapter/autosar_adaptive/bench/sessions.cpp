// Counts sessions as service discovery does, and tells those at the ends.
#include <iostream>

#include "discovery/peers.h"

int main() {
    bench::SessionCounter counter;
    for (int n = 0; n < 2 * 65535 + 1; ++n) {
        const auto session = counter.Next();
        if (session == 1 || session == 65535) {
            std::cout << session << (counter.HasWrapped() ? " down" : " up") << std::endl;
        }
    }
    return 0;
}
