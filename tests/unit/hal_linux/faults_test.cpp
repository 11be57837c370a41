// Tests every transport under every fault: the error is right, nothing hangs or leaks, and the panel is right
// again afterwards.
#include <cerrno>
#include <chrono>

#include <linux/gpio.h>
#include <linux/spi/spidev.h>

#include "tests/support/random.hpp"
#include "tests/unit/hal_linux/rig.hpp"

namespace {

using namespace linux_test;
using hal::Fault;
using sim::Call;
using sim::CallVerdict;

/// Returns whether a call carries pixels.
bool carries(const Rig& rig, const Call& call) {
    if (call.kind != Call::Kind::ioctl)
        return false;
    if (rig.spidev)
        return call.path == spi_path && _IOC_NR(call.request) == 0;
    return call.request == GPIOHANDLE_SET_LINE_VALUES_IOCTL || call.request == GPIO_V2_LINE_SET_VALUES_IOCTL;
}

class Faults : public testing::TestWithParam<Transport> {
  protected:
    /// The first `skip` calls that carry pixels pass, and the next `times` get this verdict.
    static void inject(Rig& rig, CallVerdict verdict, int skip, int times) {
        rig.machine.kernel.set_judge([&rig, verdict, skip, times](const Call& call) mutable {
            if (!carries(rig, call) || skip-- > 0 || times-- <= 0)
                return CallVerdict{};
            return verdict;
        });
    }
    /// On 3-wire SPI a list is one message, so no message can be skipped.
    static int later(int skip) {
        return GetParam() == Transport::spi3 || GetParam() == Transport::spi3_packed ? 0 : skip;
    }
    static CallVerdict error(int number) { return CallVerdict{number}; }

    /// Draws a frame that fails in this way. The next present, with nothing new to draw, must mend the glass.
    static void expect_failed_frame(Rig& rig, Fault fault, const char* says) {
        ASSERT_TRUE(rig.draw(2));
        const auto failed = rig.display->present();
        EXPECT_EQ(failed.error().fault, fault) << failed.error().rule;
        EXPECT_NE(std::string(failed.error().rule).find(says), std::string::npos) << failed.error().rule;
        EXPECT_NE(std::string(failed.error().rule).find(rig.device()), std::string::npos)
            << failed.error().rule;
        rig.machine.no_faults();
        expect_mended(rig);
    }
    static void expect_mended(Rig& rig) {
        rig.module.controller().forget_violations(); // half a transfer breaks rules of the controller
        const auto again = present(rig);
        ASSERT_TRUE(again.ok()) << again.error().rule;
        rig.module.controller().forget_violations();
        EXPECT_EQ(rig.glass_difference(), "");
    }
    /// On a busy test machine a scanned line may be polled too seldom, so a present is tried again.
    static constexpr unsigned most_tries = 6;
    static hal::Result<void> present(Rig& rig) {
        auto sent = rig.display->present();
        for (unsigned i = 1; i < most_tries && sent.error().fault == Fault::timeout; ++i)
            sent = rig.display->present();
        return sent;
    }
    /// Draws a frame whose first call returns only when the kernel is released.
    static bool draw_and_stall(Rig& rig) {
        CallVerdict stall;
        stall.stall = true;
        const bool drawn = rig.draw(2);
        inject(rig, stall, 0, 1);
        return drawn;
    }
    static void expect_unharmed_frame(Rig& rig) {
        ASSERT_TRUE(rig.draw(2));
        const auto sent = present(rig);
        EXPECT_TRUE(sent.ok()) << sent.error().rule;
        EXPECT_EQ(rig.glass_difference(), "");
    }
};

TEST_P(Faults, ShortWritesGoOn) {
    for (const std::size_t limit : {std::size_t{1}, std::size_t{7}, std::size_t{100}}) {
        Rig rig(GetParam());
        rig.start();
        CallVerdict cut;
        cut.limit = limit;
        if (GetParam() == Transport::spi3 || GetParam() == Transport::spi3_packed) {
            inject(rig, cut, 0, 1); // the transfer may have ended inside of a word
            expect_failed_frame(rig, Fault::short_write, "write: the message was cut short");
        } else { // calls on GPIO lines cannot be cut short
            inject(rig, cut, 1, 3);
            expect_unharmed_frame(rig);
        }
    }
}

TEST_P(Faults, NothingWrittenIsAnErrorNotALoop) {
    Rig rig(GetParam());
    rig.start();
    CallVerdict none;
    none.limit = 0;
    inject(rig, none, 0, 1000000);
    if (is_spidev(GetParam()))
        expect_failed_frame(rig, Fault::short_write, "write: the message was cut short");
    else
        expect_unharmed_frame(rig);
}

TEST_P(Faults, SignalsAndPatience) {
    for (const int number : {EINTR, EAGAIN}) {
        Rig rig(GetParam());
        rig.start();
        inject(rig, error(number), later(1), 5);
        expect_unharmed_frame(rig);
        const sim::Time before = rig.machine.kernel.now();
        inject(rig, error(number), later(1), 1000000);
        expect_failed_frame(rig, Fault::timeout, is_spidev(GetParam()) ? "write: " : "set: ");
        EXPECT_LT(rig.machine.kernel.now() - before, 2'000'000'000u) << "patience ends";
    }
}

TEST_P(Faults, InputOutputErrorAndTimeout) {
    for (const int skip : {0, 1, 5}) {
        Rig rig(GetParam());
        rig.start();
        if (is_spidev(GetParam()) && skip > 1)
            continue; // this message does not exist: a small frame takes one or two
        const int at = later(skip);
        inject(rig, error(EIO), at, 1);
        expect_failed_frame(rig, Fault::no_answer, "Input/output error");
        inject(rig, error(ETIMEDOUT), at, 1);
        expect_failed_frame(rig, Fault::timeout, "timed out");
    }
}

TEST_P(Faults, AHangingTransferEndsInATimeoutAndIsOverLater) {
    RigOptions options;
    options.asynchronous = true;
    Rig rig(GetParam(), options);
    rig.start();
    ASSERT_TRUE(draw_and_stall(rig));
    const auto start = std::chrono::steady_clock::now();
    const auto late = rig.display->present();
    EXPECT_EQ(late.error().fault, Fault::timeout) << late.error().rule;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
    EXPECT_EQ(rig.display->acquire().error().fault, Fault::busy) << "the frame is still being read";
    rig.machine.kernel.release();
    for (int i = 0; i < 1000 && !rig.display->acquire().ok(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    rig.machine.no_faults();
    expect_mended(rig);
}

TEST_P(Faults, ATransferThatABusyMachineDelaysIsNoFault) {
    RigOptions options;
    options.asynchronous = true;
    Rig rig(GetParam(), options);
    rig.start();
    ASSERT_TRUE(draw_and_stall(rig));
    std::thread processor([&rig] {
        for (int i = 0; i < 2000 && !rig.machine.kernel.has_stalled_calls(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        std::this_thread::sleep_for(std::chrono::milliseconds(400));
        rig.machine.kernel.release();
    });
    const auto sent = rig.display->present();
    const auto arrived = sent ? rig.display->finish() : sent;
    processor.join();
    EXPECT_TRUE(arrived.ok()) << arrived.error().rule;
    EXPECT_EQ(rig.glass_difference(), "");
}

TEST_P(Faults, PulledInTheMiddleAndPluggedAgain) {
    for (const int after : {0, 1, 20}) {
        Rig rig(GetParam());
        rig.start();
        ASSERT_TRUE(rig.draw(2));
        int left = is_spidev(GetParam()) ? after % 2 : after;
        rig.machine.kernel.set_judge([&](const Call& call) {
            if (carries(rig, call) && left-- == 0)
                rig.machine.kernel.unplug(rig.device());
            return CallVerdict{};
        });
        const auto gone = rig.display->present();
        if (GetParam() == Transport::spi3 || GetParam() == Transport::spi3_packed)
            left = 0; // a single message may end before the fault
        rig.machine.no_faults();
        if (gone.ok()) {
            rig.machine.kernel.unplug(rig.device());
            ASSERT_TRUE(rig.draw(2));
            EXPECT_EQ(rig.display->present().error().fault, Fault::gone);
        } else {
            EXPECT_EQ(gone.error().fault, Fault::gone) << gone.error().rule;
        }
        EXPECT_EQ(rig.display->present().error().fault, Fault::gone) << "as long as it is away";
        EXPECT_EQ(rig.open().error().fault, Fault::gone);
        rig.machine.kernel.plug(rig.device());
        rig.module.power_cycle();
        ASSERT_TRUE(rig.open().ok());
        ASSERT_TRUE(rig.display->init().ok());
        expect_mended(rig);
    }
}

TEST_P(Faults, ReplugBetweenFramesIsNoticed) {
    Rig rig(GetParam());
    rig.start();
    rig.machine.kernel.unplug(rig.device());
    rig.machine.kernel.plug(rig.device()); // before the bus noticed that the device was gone
    rig.module.power_cycle();
    ASSERT_TRUE(rig.draw(2));
    EXPECT_EQ(rig.display->present().error().fault, Fault::gone) << "the old file is dead";
    ASSERT_TRUE(rig.open().ok());
    ASSERT_TRUE(rig.display->init().ok());
    expect_mended(rig);
}

TEST_P(Faults, BusyLinesAndPermissions) {
    Rig rig(GetParam());
    const unsigned line = is_spidev(GetParam()) ? 25 : 11;
    rig.machine.chip.take_line(line, "somebody");
    const auto busy = rig.open();
    EXPECT_EQ(busy.error().fault, Fault::busy);
    EXPECT_NE(std::string(busy.error().rule).find("in use by 'somebody'"), std::string::npos)
        << busy.error().rule;
    EXPECT_FALSE(rig.draw(1)) << "no frame before init";
    EXPECT_FALSE(rig.display->init().ok());
    rig.machine.chip.vacate(line);
    for (const int number : {EACCES, EPERM}) {
        rig.machine.fail(number, 1, [&](const Call& call) {
            return call.kind == Call::Kind::open && call.path == rig.device();
        });
        const auto denied = rig.open();
        EXPECT_EQ(denied.error().fault, Fault::denied);
        EXPECT_NE(std::string(denied.error().rule).find("60-spangle.rules and join group"),
                  std::string::npos);
    }
    rig.machine.no_faults();
    rig.start();
    expect_unharmed_frame(rig);
}

/// The kernel stamps the edges of TE; the bus must report these times.
TEST_P(Faults, TheMomentsOfTheTearingLineAreThePanels) {
    RigOptions options;
    options.wait_te = true;
    Rig rig(GetParam(), options);
    rig.start();
    std::uint32_t moments[5] = {};
    hal::Op waits[5];
    for (int i = 0; i < 5; ++i) {
        waits[i].kind = hal::Op::Kind::wait_te;
        waits[i].micros = 100000;
        waits[i].into = reinterpret_cast<std::uint8_t*>(&moments[i]);
    }
    const auto edges = rig.bus().submit(waits, 5);
    ASSERT_TRUE(edges.ok());
    ASSERT_TRUE(rig.bus().wait(edges.value(), 1000000).ok());
    EXPECT_NEAR(moments[4] - moments[0], 4.0 * tiny_panel.timing.frame_us,
                4.0 * tiny_panel.timing.frame_us / 100);
}

TEST_P(Faults, TheTearingLineMayBeMissing) {
    RigOptions options;
    options.wait_te = true;
    Rig rig(GetParam(), options);
    rig.start();
    expect_unharmed_frame(rig);
    rig.module.cut_te(true);
    ASSERT_TRUE(rig.draw(3));
    const auto missing = rig.display->present();
    EXPECT_EQ(missing.error().fault, Fault::timeout);
    EXPECT_NE(std::string(missing.error().rule).find("TE output wired"), std::string::npos)
        << missing.error().rule;
    rig.module.cut_te(false);
    expect_mended(rig);
}

TEST_P(Faults, TheScannedLineMayNeverCome) {
    if (!can_read(GetParam()))
        return; // such lists are refused: Transfer.AListIsRefusedWholeBeforeItsFirstByte
    RigOptions options;
    options.poll_line = true;
    Rig rig(GetParam(), options);
    rig.start();
    expect_unharmed_frame(rig);
    const hal::PresentCounters counted = rig.display->counters();
    EXPECT_GE(counted.sent, 1u);
    EXPECT_LE(counted.sent, most_tries);
    EXPECT_EQ(counted.led + counted.lagged + counted.unsafe, counted.sent);
    if (is_spidev(GetParam())) { // on lines, a frame may take many refreshes
        EXPECT_EQ(counted.unsafe, 0u);
    }
    hal::Op never;
    never.kind = hal::Op::Kind::wait_line;
    never.command = 0x45;
    never.dummy_bits = hal::register_dummy_bits(rig.bus().caps(), tiny_panel);
    never.length = 5000; // no panel has so many lines
    never.stride = 9000;
    never.micros = 2000;
    const auto token = rig.bus().submit(&never, 1);
    ASSERT_TRUE(token.ok());
    const auto missing = rig.bus().wait(token.value(), 1000000);
    EXPECT_EQ(missing.error().fault, Fault::timeout);
    EXPECT_NE(std::string(missing.error().rule).find("scanned line (45h)"), std::string::npos);
    expect_unharmed_frame(rig);
}

TEST_P(Faults, ReadsFailToo) {
    if (!can_read(GetParam()))
        return; // reads are refused: Transfer.AListIsRefusedWholeBeforeItsFirstByte
    Rig rig(GetParam());
    rig.start();
    for (const int number : {EIO, ETIMEDOUT, ENODEV}) {
        inject(rig, error(number), is_spidev(GetParam()) ? 0 : 20, 1000000);
        EXPECT_FALSE(rig.display->status().ok());
        rig.machine.no_faults();
        ASSERT_TRUE(rig.draw(static_cast<unsigned>(number)));
        expect_mended(rig);
        EXPECT_EQ(rig.display->status().value().power_mode, 0x9C) << "the lines turn round again";
    }
}

// --- Random faults
/// Some calls of a sequence fail, in any way in which a kernel fails them; now and then the device is
/// unplugged.
CallVerdict chance(test::Random& random, Rig& rig, const Call& call, std::uint32_t one_in) {
    if (call.kind == Call::Kind::sleep)
        return CallVerdict{random.below(8) == 0 ? EINTR : 0};
    if (random.below(one_in) != 0)
        return {};
    constexpr int errors[] = {EINTR, EAGAIN, EIO, ETIMEDOUT, EBUSY, EACCES, ENOMEM, EINTR};
    CallVerdict verdict;
    switch (random.below(10)) {
    case 0:
        rig.machine.kernel.unplug(rig.device());
        break;
    case 1:
    case 2:
        verdict.limit = random.below(200);
        break;
    default:
        verdict.error = errors[random.below(8)];
        // A call that the kernel repeats by itself is never late; only calls that are given up may be.
        verdict.late =
            verdict.error != EINTR && verdict.error != EAGAIN && carries(rig, call) && random.below(2) == 0;
        // Only calls that carry pixels may stall: they run on the bus's own thread.
        verdict.stall = random.below(300) == 0 && carries(rig, call);
    }
    return verdict;
}

/// Opens the bus again; a transfer that hung may still be under way.
hal::Result<void> open_when_idle(Rig& rig) {
    auto opened = rig.open();
    for (int i = 0; i < 2000 && opened.error().fault == Fault::busy; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        opened = rig.open();
    }
    return opened;
}

/// Does what a program does after an error.
void mend(Rig& rig, const hal::Error& error) {
    rig.machine.kernel.plug(rig.device());
    rig.machine.kernel.release();
    if (error.fault == Fault::timeout || error.fault == Fault::short_write || error.fault == Fault::no_answer)
        return; // as a program would try again
    if (rig.open().ok())
        (void)rig.display->init();
}

TEST_P(Faults, AThousandSequencesAtRandom) {
    RigOptions options;
    options.asynchronous = true;
    Rig rig(GetParam(), options);
    rig.start();
    const int files = rig.machine.kernel.open_files();
    int failures = 0;
    for (std::uint32_t sequence = 1; sequence <= 1000; ++sequence) {
        test::Random random{sequence * 2654435761u};
        // Each frame has about one fault in this transport, or many.
        const std::uint32_t one_in = (is_spidev(GetParam())     ? 6u
                                      : is_parallel(GetParam()) ? 80u
                                                                : 600u) >>
                                     random.below(3);
        rig.machine.kernel.set_judge([&rig, one_in, faults = random](const Call& call) mutable {
            return chance(faults, rig, call, one_in);
        });
        for (unsigned frame = 0; frame < 3; ++frame) {
            const auto x = static_cast<std::int32_t>(random.below(22)),
                       y = static_cast<std::int32_t>(random.below(16)),
                       width = static_cast<std::int32_t>(random.below(3));
            // Drawing is refused while the bus reads a late frame.
            (void)rig.draw(sequence * 3 + frame, {x, y, width, 1});
            if (const auto sent = rig.display->present(); !sent.ok()) {
                ++failures;
                ASSERT_NE(sent.error().rule[0], '\0');
                mend(rig, sent.error());
            }
        }
        rig.machine.no_faults();
        rig.machine.kernel.plug(rig.device());
        rig.machine.kernel.release();
        rig.module.controller().forget_violations();
        hal::Result<void> sent = rig.display->present();
        for (int i = 0; i < 5 && !sent.ok(); ++i) { // a slow machine may miss a deadline
            const auto opened = open_when_idle(rig);
            ASSERT_TRUE(opened.ok()) << sequence << ": " << opened.error().rule;
            const auto ready = rig.display->init();
            sent = ready ? rig.display->present() : ready;
        }
        ASSERT_TRUE(sent.ok()) << sequence << ": " << sent.error().rule;
        rig.module.controller().forget_violations();
        ASSERT_EQ(rig.glass_difference(), "") << "sequence " << sequence;
        ASSERT_EQ(rig.machine.kernel.open_files(), files) << "sequence " << sequence;
    }
    EXPECT_GT(failures, 300) << "the faults reach the program";
}

INSTANTIATE_TEST_SUITE_P(, Faults, testing::ValuesIn(every_transport),
                         [](const auto& test) { return std::string(name_of(test.param)); });

} // namespace
