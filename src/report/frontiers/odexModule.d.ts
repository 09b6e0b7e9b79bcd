/** What is used of odex. Its own types are its sources, which this project's stricter compiler would refuse. */
declare module 'odex' {
  export class Solver {
    constructor(size: number)
    relativeTolerance: number
    absoluteTolerance: number
    solve(
      f: (t: number, y: number[]) => number[],
      from: number,
      start: number[],
      to: number,
      seen?: (n: number, before: number, t: number, y: number[]) => void,
    ): { y: number[]; outcome: number }
  }
}
