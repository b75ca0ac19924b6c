/**
 * A gradient from a centre outwards, known as `gq-ID`.
 * @param place attributes that say where its centre is and how far it goes; of what it fills, when left out
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
