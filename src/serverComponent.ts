/*
 * `any-frame-rate/elements` as React's server components get it. They never run in a browser, so that these have the names
 * that other files import, and no more.
 */

export class SlideLabElement {}
export class SlideFigureElement {}
export function setSite(): void {}

// eslint-disable-next-line no-console -- whoever imported it in the wrong place reads the server's console.
console.warn(
  'any-frame-rate/elements does nothing in a server component, since elements are defined in the browser. ' +
    "Import it in a file that begins with 'use client'.",
)
