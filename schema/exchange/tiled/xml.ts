/** An attribute, with the offset of its value in the text. */
export interface XmlAttribute {
  readonly value: string;
  readonly at: number;
}

/** An element of an XML text. */
export interface XmlElement {
  readonly name: string;
  /** Offset of its `<` in the text. */
  readonly at: number;
  readonly attributes: ReadonlyMap<string, XmlAttribute>;
  readonly children: XmlElement[];
  /** Its characters, without those of its children. */
  text: string;
}

/** An XML text that was read, or the first mistake in it. */
export type XmlReading =
  | { readonly ok: true; readonly root: XmlElement }
  | { readonly ok: false; readonly message: string; readonly at: number };

/** Elements may be nested this deeply. */
const DEEPEST = 64;

const ENTITIES: Readonly<Record<string, string>> = { lt: '<', gt: '>', amp: '&', quot: '"', apos: "'" };

const NAME = /[\p{L}_:][\p{L}\p{N}_:.-]*/uy;
const SPACE = /\s*/y;

class Mistake extends Error {
  readonly at: number;

  constructor(message: string, at: number) {
    super(message);
    this.at = at;
  }
}

/** The characters that a reference such as `&lt;` or `&#10;` stands for. */
function reference(name: string, at: number): string {
  const code = /^#(?:x([0-9a-f]{1,6})|(\d{1,7}))$/i.exec(name);
  if (code === null) {
    if (Object.hasOwn(ENTITIES, name)) return ENTITIES[name];
    throw new Mistake(`expected one of &lt; &gt; &amp; &quot; &apos; or a number, found &${name.slice(0, 20)};`, at);
  }
  const point = code[1] === undefined ? Number(code[2]) : Number.parseInt(code[1], 16);
  if (point > 0x10ffff) throw new Mistake(`expected a character of Unicode, found &${name};`, at);
  return String.fromCodePoint(point);
}

const decoded = (raw: string, at: number): string =>
  raw.includes('&')
    ? raw.replace(/&(?:([^;&\s]{1,40});)?/g, (_, name: string | undefined, offset: number) => {
        if (name === undefined) throw new Mistake('expected &amp; or another reference, found &', at + offset);
        return reference(name, at + offset);
      })
    : raw;

/** Reads XML as far as files of maps use it: elements, attributes, text, CDATA; without definitions of types. */
class XmlReader {
  private readonly text: string;
  private i = 0;

  constructor(text: string) {
    this.text = text;
  }

  read(): XmlElement {
    const open: XmlElement[] = [];
    let root: XmlElement | null = null;
    while (this.i < this.text.length) {
      if (this.skipped()) continue;
      const at = this.i;
      const around = open.at(-1);
      if (this.text[at] !== '<') {
        const end = this.text.indexOf('<', at);
        this.i = end < 0 ? this.text.length : end;
        this.characters(decoded(this.text.slice(at, this.i).replace(/\r\n?/g, '\n'), at), at, around);
      } else if (this.text.startsWith('<![CDATA[', at)) {
        const end = this.until(']]>', 'a CDATA section');
        this.characters(this.text.slice(at + 9, end), at, around);
      } else if (this.text.startsWith('</', at)) {
        this.i += 2;
        const name = this.name('the name of an element');
        if (around?.name !== name)
          throw new Mistake(`expected ${around === undefined ? 'nothing' : `</${around.name}>`}, found </${name}>`, at);
        this.space();
        this.expect('>');
        open.pop();
      } else {
        if (root !== null && around === undefined) throw new Mistake('expected the end of the file, found another element', at);
        const { element, isEmpty } = this.element();
        root ??= element;
        around?.children.push(element);
        if (open.length >= DEEPEST) throw new Mistake(`expected at most ${DEEPEST} elements in each other`, at);
        if (!isEmpty) open.push(element);
      }
    }
    const last = open.at(-1);
    if (last !== undefined) throw new Mistake(`expected </${last.name}>, found the end of the file`, this.text.length);
    if (root === null) throw new Mistake('expected an element, found the end of the file', this.text.length);
    return root;
  }

  private skipped(): boolean {
    if (this.text.startsWith('<!--', this.i)) this.until('-->', 'a comment');
    else if (this.text.startsWith('<?', this.i)) this.until('?>', 'an instruction');
    else if (this.text.startsWith('<!DOCTYPE', this.i)) this.until('>', 'a document type');
    else return false;
    return true;
  }

  /** Moves behind `end`, and returns where it begins. */
  private until(end: string, what: string): number {
    const at = this.text.indexOf(end, this.i);
    if (at < 0) throw new Mistake(`expected ${end}, which ends ${what}, found the end of the file`, this.i);
    this.i = at + end.length;
    return at;
  }

  private characters(text: string, at: number, around: XmlElement | undefined): void {
    if (around !== undefined) around.text += text;
    else if (text.trim() !== '') throw new Mistake('expected an element, found text', at);
  }

  private space(): void {
    SPACE.lastIndex = this.i;
    SPACE.exec(this.text);
    this.i = SPACE.lastIndex;
  }

  private expect(sign: string): void {
    if (!this.text.startsWith(sign, this.i)) throw new Mistake(`expected ${sign}, found ${this.found()}`, this.i);
    this.i += sign.length;
  }

  private found(): string {
    return this.i < this.text.length ? JSON.stringify(this.text[this.i]) : 'the end of the file';
  }

  private name(what: string): string {
    NAME.lastIndex = this.i;
    const match = NAME.exec(this.text);
    if (match === null) throw new Mistake(`expected ${what}, found ${this.found()}`, this.i);
    this.i = NAME.lastIndex;
    return match[0];
  }

  private element(): { element: XmlElement; isEmpty: boolean } {
    const at = this.i++;
    const name = this.name('the name of an element');
    const attributes = new Map<string, XmlAttribute>();
    for (;;) {
      this.space();
      const isEmpty = this.text.startsWith('/>', this.i);
      if (isEmpty || this.text[this.i] === '>') {
        this.i += isEmpty ? 2 : 1;
        return { element: { name, at, attributes, children: [], text: '' }, isEmpty };
      }
      const start = this.i;
      const key = this.name('an attribute or >');
      if (attributes.has(key)) throw new Mistake(`the attribute ${key} is there more than once`, start);
      this.space();
      this.expect('=');
      this.space();
      attributes.set(key, this.value());
    }
  }

  private value(): XmlAttribute {
    const quote = this.text[this.i];
    if (quote !== '"' && quote !== "'") throw new Mistake(`expected a text in quotes, found ${this.found()}`, this.i);
    const at = ++this.i;
    const end = this.until(quote, 'the text');
    return { value: decoded(this.text.slice(at, end).replace(/\r\n|[\r\n\t]/g, ' '), at), at };
  }
}

/** Reads an XML text. */
export function readXml(text: string): XmlReading {
  try {
    return { ok: true, root: new XmlReader(text).read() };
  } catch (error) {
    if (error instanceof Mistake) return { ok: false, message: error.message, at: error.at };
    throw error;
  }
}
