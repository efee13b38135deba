// What the program does when it is interrupted (SIGINT, which Ctrl-C sends, SIGTERM, SIGHUP): within a second it says
// so and exits with 128 + the signal's number, as shells count it, and leaves no file that is not whole.
#pragma once

#include "stop.h"

namespace gnomon {

/// From now on, in the calling thread, which has to be the one that writes files. A signal that whoever started the
/// program ignores stays ignored, as nohup wants it.
void catch_interrupts();

/// Whether one has been caught: then whatever fails may fail because of it, as LLVM does when it compiles meanwhile.
bool was_interrupted();
/// The exit code after that, which is said on stderr.
int interrupted();

/// While it lives, an interrupt asks for a stop, and ends the program itself only if that has not been heeded within
/// half a second (a driver that compiles heeds nothing) or if it is repeated. At other times it ends the program at
/// once: there is nothing to tidy up but temporary files. There may be one at a time.
class Stoppable {
  public:
    Stoppable();
    ~Stoppable();
    Stoppable(const Stoppable&) = delete;
    Stoppable& operator=(const Stoppable&) = delete;

    const Stop* stop() const { return &stop_; }

  private:
    Stop stop_;
};

}  // namespace gnomon
