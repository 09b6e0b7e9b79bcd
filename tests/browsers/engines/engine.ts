/** A point of the window, or its size [px]. */
export type Point = { x: number; y: number }

/** One window of a browser: as much as all three engines' drivers can do. */
export type Tab = {
  /** Loads an address at a size of the window and waits for the page's `load`. */
  open: (address: string, size: { width: number; height: number }) => Promise<void>
  /** Runs a function in the page. It takes and returns what JSON holds, and sees nothing of the test. */
  run: <T, A extends readonly unknown[]>(
    call: (...given: A) => T | Promise<T>,
    ...given: A
  ) => Promise<T>
  /** Presses the mouse at the first point and lets it go at the last. */
  drag: (...points: Point[]) => Promise<void>
  /** Presses a key, with its name in the DOM: `ArrowRight`. */
  press: (key: string) => Promise<void>
  /** What the window shows, as a PNG. */
  shoot: () => Promise<Buffer>
  close: () => Promise<void>
}

/** A browser's engine: what starts it, and what brings it where it is missing. */
export type Engine = {
  name: string
  install: string
  isInstalled: () => boolean
  start: () => Promise<Tab>
}
