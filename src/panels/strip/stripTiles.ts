/** A stretch of time [s]. */
export interface TimeSpan {
  readonly from: number
  readonly to: number
}

/**
 * While it plays, a view that follows the cursor is put together from tiles, each of them drawn once: to copy two pictures
 * takes less time than to draw hundreds of ticks at every frame.
 */
export class StripTiles {
  private readonly tiles = new Map<number, HTMLCanvasElement>()
  private readonly drawTile: (canvas: HTMLCanvasElement, stretch: TimeSpan) => void

  constructor(drawTile: (canvas: HTMLCanvasElement, stretch: TimeSpan) => void) {
    this.drawTile = drawTile
  }

  /** To be called when anything but the time has changed. */
  forget(): void {
    this.tiles.clear()
  }

  /** Draws a stretch, as long as a tile, over a canvas whose last tick is so wide [its pixels]. */
  draw(pen: CanvasRenderingContext2D, { from, to }: TimeSpan, tick: number): void {
    const { width, height } = pen.canvas
    const length = to - from
    const first = Math.floor(from / length)
    for (const i of this.tiles.keys()) if (i < first || i > first + 1) this.tiles.delete(i)
    const place = (i: number) => Math.round((i - from / length) * (width - tick))
    for (const i of [first, first + 1]) {
      const tile = this.tile(i, length)
      const x = place(i)
      const part = Math.min(place(i + 1), width) - x
      if (part > 0) pen.drawImage(tile, 0, 0, part, height, x, 0, part, height)
    }
  }

  private tile(i: number, length: number): HTMLCanvasElement {
    let tile = this.tiles.get(i)
    if (!tile) {
      tile = document.createElement('canvas')
      this.tiles.set(i, tile)
      this.drawTile(tile, { from: i * length, to: (i + 1) * length })
    }
    return tile
  }
}
