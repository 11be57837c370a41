// SPDX-License-Identifier: MIT
// A machine whose display header is a gpio-sim chip labelled "display-header", with the buses of a Raspberry Pi's
// bit-banged on its lines: SPI bus 0 and /dev/spidev0.0 on 8 to 11, I2C bus 1 on 2 and 3. They come when the chip does:
// until then their probes wait.
#include <linux/gpio/machine.h>
#include <linux/init.h>
#include <linux/platform_data/i2c-gpio.h>
#include <linux/platform_device.h>
#include <linux/spi/spi.h>
#include <linux/spi/spi_gpio.h>

#define HEADER "display-header"

// Levels as spi-gpio means them: it drives CS by SPI_CS_HIGH, so the line itself is not inverted.
static struct gpiod_lookup_table spi_lines = {
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

static struct spi_gpio_platform_data spi_bus = { .num_chipselect = 1 };

static struct gpiod_lookup_table i2c_lines = {
	.dev_id = "i2c-gpio.1",
	.table = {
		GPIO_LOOKUP(HEADER, 2, "sda", GPIO_ACTIVE_HIGH),
		GPIO_LOOKUP(HEADER, 3, "scl", GPIO_ACTIVE_HIGH),
		{},
	},
};

// SCL is driven both ways and not read. SDA is let go of for a high level; a simulated line then keeps the level it was
// last driven to, which was low: every byte is acknowledged.
static struct i2c_gpio_platform_data i2c_bus = {
	.udelay = 5,
	.scl_is_open_drain = 1,
	.scl_is_output_only = 1,
};

static int __init spangle_board(void)
{
	struct platform_device *spi, *i2c;

	gpiod_add_lookup_table(&spi_lines);
	gpiod_add_lookup_table(&i2c_lines);
	spi_register_board_info(&display, 1);
	spi = platform_device_register_data(NULL, "spi_gpio", 0, &spi_bus, sizeof(spi_bus));
	i2c = platform_device_register_data(NULL, "i2c-gpio", 1, &i2c_bus, sizeof(i2c_bus));
	return PTR_ERR_OR_ZERO(spi) ?: PTR_ERR_OR_ZERO(i2c);
}
device_initcall(spangle_board);
