#!/bin/sh
# The first process of the tests' kernel, whose root is the host's: runs a program, says how it ended, switches off.
# usage: init.sh PROGRAM WORDS...
echo 'the kernel runs'
export PATH=/usr/sbin:/usr/bin:/sbin:/bin TMPDIR=/run HOME=/run
mount -t proc proc /proc
mount -t sysfs sysfs /sys
mount -t devtmpfs devtmpfs /dev
mount -t configfs configfs /sys/kernel/config
mount -t tracefs tracefs /sys/kernel/tracing
mount -t tmpfs tmpfs /run
mkdir /run/udev # where libusb looks for udev, and finds that it does not run
"$@"
status=$?
[ $status -eq 0 ] || dmesg | tail -n 30
echo "ended with status $status"
echo o >/proc/sysrq-trigger
sleep 10
