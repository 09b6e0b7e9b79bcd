import { readdirSync, readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { extname, join } from 'node:path'
import { gzipSync } from 'node:zlib'

const types = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
}

/**
 * Serves a folder as GitHub Pages and its kind do, text compressed and kept for ten minutes, and returns its address and
 * how to end it.
 */
export async function host(folder) {
  const files = new Map()
  for (const entry of readdirSync(folder, { recursive: true, withFileTypes: true })) {
    if (!entry.isFile()) continue
    const path = join(entry.parentPath, entry.name)
    const type = types[extname(path)]
    const content = readFileSync(path)
    const headers = {
      'Cache-Control': 'max-age=600',
      'Content-Type': type ?? 'application/octet-stream',
      ...(type && { 'Content-Encoding': 'gzip', Vary: 'Accept-Encoding' }),
    }
    const address = path.slice(folder.length).replaceAll('\\', '/')
    files.set(address, { headers, body: type ? gzipSync(content) : content })
  }
  files.set('/', files.get('/index.html'))

  const server = createServer(({ url }, response) => {
    const file = files.get(new URL(url, 'http://host').pathname)
    if (!file) return void response.writeHead(404).end()
    response.writeHead(200, { ...file.headers, 'Content-Length': file.body.length }).end(file.body)
  })
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening))
  return {
    address: `http://127.0.0.1:${server.address().port}/`,
    close: () => {
      server.closeAllConnections()
      server.close()
    },
  }
}
