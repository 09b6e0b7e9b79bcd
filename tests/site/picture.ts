import { PNG } from 'pngjs'
import { expect } from 'vitest'

/**
 * How far the same drawing may be from itself, in a channel of a pixel [1/255]: where the browser keeps a canvas in
 * memory decides which instructions fill its edges, and some round the last level otherwise.
 */
const ROUNDING = 1

/** A picture that was taken of the page. `toEqual` compares it with another, up to the browser's own rounding. */
export class Picture {
  readonly width: number
  readonly height: number
  // Hidden from the message of a test that fails: it is long.
  readonly #data: Buffer

  /** @param png as a file or as a data URL */
  constructor(png: Buffer | string) {
    const file = typeof png === 'string' ? Buffer.from(png.split(',')[1]!, 'base64') : png
    const { width, height, data } = PNG.sync.read(file)
    this.width = width
    this.height = height
    this.#data = data
  }

  /** The share of pixels that differ from another picture's by more than so many levels in a channel; 1 where the sizes do. */
  differing(from: Picture, levels: number): number {
    if (this.width !== from.width || this.height !== from.height) return 1
    let count = 0
    for (let pixel = 0; pixel < this.#data.length; pixel += 4) {
      for (let i = pixel; i < pixel + 4; i++) {
        if (Math.abs(this.#data[i]! - from.#data[i]!) > levels) {
          count++
          break
        }
      }
    }
    return count / (this.width * this.height)
  }
}

expect.addEqualityTesters([
  (one: unknown, other: unknown) =>
    one instanceof Picture && other instanceof Picture
      ? one.differing(other, ROUNDING) === 0
      : undefined,
])
