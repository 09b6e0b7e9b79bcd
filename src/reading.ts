/* What the page has besides its lab. */
import './figure/defineFigure.ts'
import './tutorial/index.ts'
