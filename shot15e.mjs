import { chromium } from 'playwright-core'
import { join } from 'path'
const folder = join(process.cwd(),'node_modules/.cache/chromium-143.0.4')
export async function open(width, scheme, url='http://localhost:4212/') {
  const b = await chromium.launch({ executablePath: join(folder,'chromium'), args:['--no-sandbox','--font-render-hinting=none'], env:{...process.env, LD_LIBRARY_PATH: join(folder,'al2023/lib'), FONTCONFIG_PATH: join(folder,'fonts')}})
  const page = await b.newPage({ viewport:{width,height:900}, colorScheme: scheme })
  page.on('pageerror', e=>console.log('ERR',e.message)); page.on('console', m=>m.type()==='error'&&console.log('C',m.text()))
  await page.goto(url); return {b,page}
}
