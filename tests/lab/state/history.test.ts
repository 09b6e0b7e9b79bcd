import { describe, expect, it } from 'vitest'
import { History } from '../../../src/lab/state/history.ts'

describe('history', () => {
  it('goes back and on through what was added', () => {
    const history = new History('a')
    expect([history.canUndo, history.canRedo, history.undo(), history.redo()]).toEqual([
      false,
      false,
      undefined,
      undefined,
    ])
    history.add('b', 'x', 0)
    history.add('c', 'y', 1)
    expect(history.undo()).toBe('b')
    expect(history.undo()).toBe('a')
    expect(history.canUndo).toBe(false)
    expect(history.redo()).toBe('b')
    expect(history.redo()).toBe('c')
    expect(history.canRedo).toBe(false)
  })

  it('forgets what was undone when something else is done', () => {
    const history = new History('a')
    history.add('b', 'x', 0)
    history.undo()
    history.add('c', 'x', 0)
    expect(history.canRedo).toBe(false)
    expect(history.undo()).toBe('a')
  })

  it('takes a drag back in one go, and two drags in two', () => {
    const history = new History(0)
    for (let i = 1; i <= 50; i++) history.add(i, 'angle', 16 * i)
    for (let i = 51; i <= 60; i++) history.add(i, 'angle', 5000 + 16 * i)
    expect(history.undo()).toBe(50)
    expect(history.undo()).toBe(0)
  })

  it('an undo group does not continue across an undo', () => {
    const history = new History(0)
    history.add(1, 'angle', 0)
    history.add(2, 'speed', 10)
    history.undo()
    history.add(3, 'speed', 20)
    expect(history.undo()).toBe(1)
  })

  it('keeps changes apart that belong to nothing', () => {
    const history = new History(0)
    for (let i = 1; i <= 3; i++) history.add(i, undefined, i)
    expect(history.present).toBe(3)
    expect(history.undo()).toBe(2)
    expect(history.present).toBe(2)
  })

  it('keeps a bounded number of states', () => {
    const history = new History(0)
    for (let i = 1; i <= 1000; i++) history.add(i, String(i), i)
    let steps = 0
    while (history.undo() !== undefined) steps++
    expect(steps).toBe(199)
  })
})
