import { spawn } from 'node:child_process'
import type { ChildProcess } from 'node:child_process'
import { existsSync, readdirSync } from 'node:fs'
import { createServer } from 'node:net'
import type { AddressInfo } from 'node:net'
import { PNG } from 'pngjs'
import type { Engine, Tab } from './engine.ts'

const libraries = existsSync('/usr/lib') ? readdirSync('/usr/lib') : []
const binary = libraries
  .map((each) => `/usr/lib/${each}/webkit2gtk-4.1/MiniBrowser`)
  .find((each) => existsSync(each))

/** WebDriver's codes of the keys that have no letter. */
const KEYS: Record<string, string> = {
  ArrowLeft: '\uE012',
  ArrowUp: '\uE013',
  ArrowRight: '\uE014',
  ArrowDown: '\uE015',
  Enter: '\uE007',
  Tab: '\uE004',
  Home: '\uE011',
  End: '\uE010',
}

/** WebKitGTK's MiniBrowser by plain WebDriver, on a screen that only exists in memory. */
export const webkit: Engine = {
  name: 'WebKit',
  install: 'apt-get install --no-install-recommends webkit2gtk-driver xvfb',
  isInstalled: () =>
    binary !== undefined &&
    ['/usr/bin/WebKitWebDriver', '/usr/bin/Xvfb'].every((each) => existsSync(each)),
  start: async () => {
    const screen = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1600x1200x24'], {
      stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
    })
    const display = await new Promise<string>((found, fail) => {
      screen.once('exit', () => fail(new Error('Xvfb did not start.')))
      screen.stdio[3]!.once('data', (text: Buffer) => found(text.toString().trim()))
    })
    const port = await freePort()
    const driver = spawn('WebKitWebDriver', [`--port=${port}`], {
      stdio: 'ignore',
      env: {
        ...process.env,
        DISPLAY: `:${display}`,
        WEBKIT_DISABLE_COMPOSITING_MODE: '1',
        WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1',
        LIBGL_ALWAYS_SOFTWARE: '1',
      },
    })
    return tabOf(`http://127.0.0.1:${port}`, [driver, screen])
  },
}

async function tabOf(driver: string, processes: readonly ChildProcess[]): Promise<Tab> {
  const call = async (method: string, path: string, body?: unknown): Promise<unknown> => {
    const answer = await fetch(driver + path, {
      method,
      ...(body === undefined ? {} : { body: JSON.stringify(body) }),
    })
    const { value } = (await answer.json()) as { value: { message?: string } | null }
    if (!answer.ok) throw new Error(`WebDriver ${path}: ${value?.message ?? answer.status}`)
    return value
  }
  await listening(driver)
  const { sessionId } = (await call('POST', '/session', {
    capabilities: {
      alwaysMatch: { 'webkitgtk:browserOptions': { binary, args: ['--automation'] } },
    },
  })) as { sessionId: string }
  const session = `/session/${sessionId}`
  const script = (body: string, args: readonly unknown[] = []) =>
    call('POST', `${session}/execute/async`, { script: body, args })
  const act = (type: 'pointer' | 'key', actions: readonly object[]) =>
    call('POST', `${session}/actions`, { actions: [{ type, id: type, actions }] })
  let shown = { width: 0, height: 0 }

  return {
    open: async (address, size) => {
      shown = size
      await call('POST', `${session}/frame`, { id: null })
      await call('POST', `${session}/window/rect`, { width: 1500, height: 1150 })
      // A window cannot be as narrow as a phone; a frame in it can.
      await call('POST', `${session}/url`, { url: new URL('blank.html', address).href })
      await script(FRAME, [address, size.width, size.height])
      await call('POST', `${session}/frame`, { id: 0 })
    },
    run: async (given, ...args) => {
      const result = (await script(RUN(given.toString()), args)) as {
        value?: never
        error?: string
      }
      if (result.error !== undefined) throw new Error(result.error)
      return result.value as never
    },
    drag: async (first, ...others) => {
      const move = ({ x, y }: { x: number; y: number }) => ({
        type: 'pointerMove',
        x: Math.round(x),
        y: Math.round(y),
        duration: 0,
      })
      await act('pointer', [
        move(first!),
        { type: 'pointerDown', button: 0 },
        ...others.map(move),
        { type: 'pointerUp', button: 0 },
      ])
    },
    press: async (key) => {
      const value = KEYS[key] ?? key
      await act('key', [
        { type: 'keyDown', value },
        { type: 'keyUp', value },
      ])
    },
    shoot: async () =>
      cut(Buffer.from((await call('GET', `${session}/screenshot`)) as string, 'base64'), shown),
    close: async () => {
      await call('DELETE', session).catch(() => undefined)
      for (const each of processes) each.kill()
    },
  }
}

const FRAME = `
const [address, width, height, done] = arguments
document.body.style.margin = 0
const frame = document.createElement('iframe')
frame.style.cssText = 'border: 0; display: block; width: ' + width + 'px; height: ' + height + 'px'
frame.onload = () => done()
frame.src = address
document.body.replaceChildren(frame)`

const RUN = (call: string) => `
const done = arguments[arguments.length - 1]
Promise.resolve()
  .then(() => (${call})(...[...arguments].slice(0, -1)))
  .then((value) => done({ value }), (error) => done({ error: String(error) }))`

/** The top left corner of a picture: the frame without the window around it. */
function cut(file: Buffer, { width, height }: { width: number; height: number }): Buffer {
  const corner = new PNG({ width, height })
  PNG.bitblt(PNG.sync.read(file), corner, 0, 0, width, height, 0, 0)
  return PNG.sync.write(corner)
}

async function freePort(): Promise<number> {
  const server = createServer()
  await new Promise<void>((done) => server.listen(0, '127.0.0.1', done))
  const { port } = server.address() as AddressInfo
  await new Promise((done) => server.close(done))
  return port
}

async function listening(driver: string): Promise<void> {
  for (let tries = 0; tries < 100; tries++) {
    const answer = await fetch(`${driver}/status`).catch(() => undefined)
    if (answer) return
    await new Promise((done) => setTimeout(done, 100))
  }
  throw new Error('WebKitWebDriver does not answer.')
}
