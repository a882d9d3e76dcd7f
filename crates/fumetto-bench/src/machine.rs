//! What the figures were taken on.

use std::{env::consts, fs, thread};

/// The adapter in words. A software one is told apart, for its figures say nothing about graphics cards.
pub(crate) fn adapter(info: &wgpu::AdapterInfo) -> String {
    let kind =
        if info.device_type == wgpu::DeviceType::Cpu { ", software: draws on the processor" } else { "" };
    format!("{} ({}{kind})", info.name, info.backend)
}

/// The processor, its cores, and the system.
pub(crate) fn describe() -> String {
    let cores = thread::available_parallelism().map_or(1, usize::from);
    // Only Linux has this file; elsewhere the architecture has to do.
    let cpuinfo = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor = processor(&cpuinfo).unwrap_or(consts::ARCH);
    let build = if cfg!(debug_assertions) { ", a debug build: its figures mean little" } else { "" };
    format!("{processor}, {cores} cores, {}{build}", consts::OS)
}

fn processor(cpuinfo: &str) -> Option<&str> {
    let line = cpuinfo.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_processor_is_named_where_the_system_tells() {
        let cpuinfo = "processor\t: 0\nmodel name\t: Some CPU @ 2.00GHz\nmodel name\t: Other\n";
        assert_eq!(processor(cpuinfo), Some("Some CPU @ 2.00GHz"));
        assert_eq!(processor("Features : fp asimd"), None);
    }
}
