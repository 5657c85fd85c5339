// Controls a headless Chromium by its DevTools protocol over a pipe, without a driver or other dependencies.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** Starts a browser. @param {string} [program] */
export async function chromium(program = process.env.CHROMIUM ?? 'chromium') {
  const profile = mkdtempSync(join(tmpdir(), 'nanospectra-'));
  const child = spawn(
    program,
    [
      '--headless=new',
      '--no-sandbox',
      '--disable-gpu',
      '--disable-dev-shm-usage',
      '--remote-debugging-pipe',
      '--hide-scrollbars',
      '--no-first-run',
      `--user-data-dir=${profile}`,
      'about:blank',
    ],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] },
  );
  const waiting = new Map(),
    listeners = new Set();
  let id = 0,
    rest = '';
  child.stdio[4].setEncoding('utf8').on('data', (text) => {
    const parts = (rest + text).split('\0');
    rest = parts.pop();
    for (const part of parts) {
      const message = JSON.parse(part);
      if (message.id === undefined) listeners.forEach((listener) => listener(message));
      else {
        const { resolve, reject, method } = waiting.get(message.id);
        waiting.delete(message.id);
        message.error ? reject(new Error(`${method}: ${message.error.message}`)) : resolve(message.result);
      }
    }
  });
  const gone = new Promise((resolve) => {
    child.on('exit', resolve);
  });
  child.on('error', (error) => {
    for (const { reject } of waiting.values()) reject(error);
  });
  const send = (method, params = {}, sessionId) =>
    new Promise((resolve, reject) => {
      waiting.set(++id, { resolve, reject, method });
      child.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    });

  return {
    /** Opens a new page, which records its errors and requests. */
    async page() {
      const { targetId } = await send('Target.createTarget', { url: 'about:blank' });
      const { sessionId } = await send('Target.attachToTarget', { targetId, flatten: true });
      return new Page(
        (method, params) => send(method, params, sessionId),
        (listener) => {
          listeners.add((message) => {
            if (message.sessionId === sessionId) listener(message);
          });
        },
      ).start();
    },
    async close() {
      await send('Browser.close').catch(() => {});
      await Promise.race([
        gone,
        new Promise((resolve) => {
          setTimeout(resolve, 3000);
        }),
      ]);
      child.kill('SIGKILL');
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}

class Page {
  constructor(send, listen) {
    this.send = send;
    /** The errors of the page: exceptions, console errors and failed requests. @type {string[]} */
    this.errors = [];
    /** The addresses of all requests. @type {string[]} */
    this.requests = [];
    listen(({ method, params }) => {
      if (method === 'Runtime.exceptionThrown')
        this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
      if (method === 'Runtime.consoleAPICalled' && ['error', 'warning'].includes(params.type))
        this.errors.push(params.args.map((arg) => arg.value).join(' '));
      if (method === 'Log.entryAdded' && params.entry.level === 'error')
        this.errors.push(`${params.entry.text} ${params.entry.url ?? ''}`);
      if (method === 'Network.requestWillBeSent') this.requests.push(params.request.url);
    });
  }

  async start() {
    for (const domain of ['Page', 'Runtime', 'Log', 'Network', 'DOM']) await this.send(`${domain}.enable`);
    return this;
  }

  async size(width, height, mobile = false) {
    await this.send('Emulation.setDeviceMetricsOverride', {
      width,
      height,
      deviceScaleFactor: mobile ? 2 : 1,
      mobile,
    });
    await this.send('Emulation.setTouchEmulationEnabled', { enabled: mobile });
  }

  /** @param {string} url */
  async open(url) {
    await this.send('Page.navigate', { url: 'about:blank' });
    await this.send('Page.navigate', { url });
    await this.until("document.documentElement?.dataset.ready === 'yes'");
  }

  /** Returns the value of an expression in the page. @param {string} expression */
  async value(expression) {
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', {
      expression,
      returnByValue: true,
      awaitPromise: true,
    });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /** Waits until an expression is true. @param {string} expression */
  async until(expression) {
    for (let k = 0; k < 300; k++) {
      if (await this.value(`Boolean(${expression})`).catch(() => false)) return;
      await new Promise((resolve) => {
        setTimeout(resolve, 50);
      });
    }
    throw new Error(`waited in vain for ${expression}; ${this.errors.join('; ')}`);
  }

  /** Puts files into a file input. @param {string} selector @param {string[]} files */
  async choose(selector, files) {
    const { root } = await this.send('DOM.getDocument');
    const { nodeId } = await this.send('DOM.querySelector', { nodeId: root.nodeId, selector });
    await this.send('DOM.setFileInputFiles', { nodeId, files });
  }

  /** Chooses an option as a reader would. */
  select(selector, value) {
    return this.value(
      `(() => { const s = document.querySelector(${JSON.stringify(selector)}); s.value = ${JSON.stringify(value)}; s.dispatchEvent(new Event('change', { bubbles: true })); })()`,
    );
  }

  /** Scrolls an element into view and returns its middle. */
  async place(selector) {
    return this.value(
      `(() => { const e = document.querySelector(${JSON.stringify(selector)}); e.scrollIntoView({ block: 'center' }); const b = e.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()`,
    );
  }

  async click(selector) {
    const [left, top, width, height] = await this.place(selector);
    const at = { x: left + width / 2, y: top + height / 2, button: 'left', clickCount: 1 };
    await this.send('Input.dispatchMouseEvent', { type: 'mousePressed', ...at });
    await this.send('Input.dispatchMouseEvent', { type: 'mouseReleased', ...at });
  }

  /** Drags along points that are given as shares of an element's box. @param {[number, number][]} points */
  async drag(selector, points) {
    const [left, top, width, height] = await this.place(selector);
    const at = ([x, y]) => ({
      x: left + x * width,
      y: top + y * height,
      button: 'left',
      buttons: 1,
      clickCount: 1,
    });
    await this.send('Input.dispatchMouseEvent', { type: 'mousePressed', ...at(points[0]) });
    for (const point of points) await this.send('Input.dispatchMouseEvent', { type: 'mouseMoved', ...at(point) });
    await this.send('Input.dispatchMouseEvent', { type: 'mouseReleased', ...at(points.at(-1)) });
  }

  /** @param {string} key @param {number} [times] */
  async press(key, times = 1) {
    for (let k = 0; k < times; k++) {
      await this.send('Input.dispatchKeyEvent', {
        type: 'keyDown',
        key,
        code: key,
        windowsVirtualKeyCode: {
          Tab: 9,
          ArrowLeft: 37,
          ArrowUp: 38,
          ArrowRight: 39,
          ArrowDown: 40,
          Enter: 13,
          ' ': 32,
        }[key],
      });
      await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key, code: key });
    }
  }

  /** @returns {Promise<Buffer>} */
  async screenshot(whole = false) {
    const clip = whole
      ? await this.value(
          '({ x: 0, y: 0, width: document.documentElement.clientWidth, height: document.documentElement.scrollHeight, scale: 1 })',
        )
      : undefined;
    const { data } = await this.send('Page.captureScreenshot', {
      format: 'png',
      captureBeyondViewport: whole,
      clip,
    });
    return Buffer.from(data, 'base64');
  }
}
