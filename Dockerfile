# One image for the server and the vehicle node; docker-compose.yml gives each its command.
FROM python:3.12-slim-bookworm AS build
WORKDIR /src
# the user that runs the image may not write bytecode, so it is made here
ENV UV_COMPILE_BYTECODE=1
COPY requirements-build.lock requirements.lock ./
RUN python -m venv /opt/build \
    && /opt/build/bin/pip install --no-cache-dir --require-hashes -r requirements-build.lock \
    && python -m venv --without-pip /opt/bumpless \
    && /opt/build/bin/uv pip install --no-cache --python /opt/bumpless/bin/python --require-hashes \
        -r requirements.lock
COPY . .
RUN /opt/build/bin/python -m hatchling build -t wheel \
    && /opt/build/bin/uv pip install --no-cache --python /opt/bumpless/bin/python --no-deps dist/*.whl

FROM python:3.12-slim-bookworm
RUN useradd --system --uid 10001 --no-create-home bumpless \
    && install -d -o bumpless /data /var/cache/bumpless
COPY --from=build /opt/bumpless /opt/bumpless
ENV PATH=/opt/bumpless/bin:$PATH \
    PYTHONUNBUFFERED=1 \
    NUMBA_CACHE_DIR=/var/cache/bumpless \
    BUMPLESS_DATA_DIR=/data
USER 10001
WORKDIR /data
# Compiled for the processor that builds the image; another one compiles once more at its first start.
RUN python -m bumpless.sim.warm_up
VOLUME /data
EXPOSE 8080
ENTRYPOINT ["bumpless"]
CMD ["serve"]
