// SPDX-License-Identifier: MIT
// A machine whose display header is a gpio-sim chip labelled "display-header": SPI bus 0 bit-banged on its lines 8 to
// 11, as on a Raspberry Pi, and /dev/spidev0.0 on that. The bus comes when the chip does: until then its probe waits.
#include <linux/gpio/machine.h>
#include <linux/init.h>
#include <linux/platform_device.h>
#include <linux/spi/spi.h>
#include <linux/spi/spi_gpio.h>

#define HEADER "display-header"

// Levels as spi-gpio means them: it drives CS by SPI_CS_HIGH, so the line itself is not inverted.
static struct gpiod_lookup_table lines = {
	.dev_id = "spi_gpio.0",
	.table = {
		GPIO_LOOKUP(HEADER, 11, "sck", GPIO_ACTIVE_HIGH),
		GPIO_LOOKUP(HEADER, 10, "mosi", GPIO_ACTIVE_HIGH),
		GPIO_LOOKUP(HEADER, 9, "miso", GPIO_ACTIVE_HIGH),
		GPIO_LOOKUP_IDX(HEADER, 8, "cs", 0, GPIO_ACTIVE_HIGH),
		{},
	},
};

// One of the names spidev binds to.
static struct spi_board_info display = {
	.modalias = "dh2228fv",
	.max_speed_hz = 50000000,
	.bus_num = 0,
	.chip_select = 0,
	.mode = SPI_MODE_0,
};

static struct spi_gpio_platform_data bus = { .num_chipselect = 1 };

static int __init spangle_board(void)
{
	struct platform_device *device;

	gpiod_add_lookup_table(&lines);
	spi_register_board_info(&display, 1);
	device = platform_device_register_data(NULL, "spi_gpio", 0, &bus, sizeof(bus));
	return PTR_ERR_OR_ZERO(device);
}
device_initcall(spangle_board);
