const ENTITIES: Record<string, string> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };

// XML 1.0 cannot represent these characters, not even escaped.
// biome-ignore lint/suspicious/noControlCharactersInRegex: control characters are what is looked for
const FORBIDDEN = /[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]|\p{Surrogate}/gu;

/** Escapes any text for the inside of an element or of a quoted attribute. */
export const escapeXml = (text: string): string => text.replace(FORBIDDEN, '\ufffd').replace(/[&<>"']/g, (c) => ENTITIES[c]);

/** Formats a number for an attribute: at most two decimals, no exponent, no minus zero. */
export function num(value: number): string {
  const rounded = Math.round(value * 100) / 100;
  return rounded === 0 ? '0' : String(rounded);
}

/** Formats points as the data of a path: `M x y L x y …`, with rounded numbers. */
export function polyline(points: readonly (readonly [number, number])[], close = false): string {
  return `M${points.map(([x, y]) => `${num(x)} ${num(y)}`).join('L')}${close ? 'Z' : ''}`;
}

/**
 * A radial gradient with the id `gq-ID`.
 * @param place attributes for its centre and radius; by default those of the shape that it fills
 */
export const radial = (
  id: string,
  stops: readonly (readonly [offset: number, color: string, opacity?: number])[],
  place = '',
): string =>
  `<radialGradient id="gq-${id}"${place}>${stops
    .map(([offset, color, opacity]) => {
      const alpha = opacity === undefined ? '' : ` stop-opacity="${opacity}"`;
      return `<stop offset="${offset}" stop-color="${color}"${alpha}/>`;
    })
    .join('')}</radialGradient>`;
