"""The table of keys is the only speller of Zenoh keys: it must cover the contract and read back."""

import pytest
import zenoh
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless.contract.messages import descriptor_set


def test_every_stamped_telemetry_message_has_a_topic() -> None:
    """A message that starts with a stamp but has no topic could never be logged."""
    stamped = {
        name
        for name, message in pb.DESCRIPTOR.message_types_by_name.items()
        if message.fields and message.fields[0].name == "stamp"
    }
    assert stamped == {topic.schema.split(".")[1] for topic in keys.TOPICS.values()} | {"Event", "TruthState"}


def test_keys_are_canonical_and_read_back() -> None:
    """Zenoh accepts only canonical expressions, and the server finds topic and vehicle in them."""
    spelled = [keys.telemetry("ts100", name) for name in keys.TOPICS]
    spelled += [keys.command("ts100", verb) for verb in keys.COMMANDS]
    spelled += [keys.event("ts100"), keys.alive("ts100"), keys.truth("ts100"), keys.schema("ts100")]
    assert len(set(spelled)) == len(spelled)
    for key in spelled:
        assert str(zenoh.KeyExpr(key)) == key
        assert keys.vehicle_of(key) == "ts100"
        assert key.endswith("/" + keys.topic_of(key))


@pytest.mark.parametrize("key", ["", "bumpless", "bumpless/ts100", "other/ts100/tlm/control"])
def test_foreign_keys_are_refused(key: str) -> None:
    """A stray publisher must not be taken for a vehicle."""
    with pytest.raises(ValueError, match="not a key"):
        keys.topic_of(key)


@pytest.mark.parametrize("vehicle", ["", "*", "a/b", "TS100", "a" * 33, "-x", "ts 100", "ts100\n"])
def test_vehicle_id_must_not_change_the_key(vehicle: str) -> None:
    """An id with a slash or a star would speak for, or listen to, other vehicles."""
    with pytest.raises(ValueError, match="vehicle id"):
        keys.check_vehicle_id(vehicle)


def test_encoding_names_the_message() -> None:
    """The encoding alone must say how to read a payload."""
    encoding = keys.encoding_of(pb.Navigation)
    assert encoding == "application/protobuf;bumpless.Navigation"
    assert str(zenoh.Encoding(encoding)) == encoding
    assert keys.schema_of(encoding) == "bumpless.Navigation"
    with pytest.raises(ValueError, match="protobuf"):
        keys.schema_of("text/plain")


def test_descriptor_set_alone_decodes_a_payload() -> None:
    """A reader without our code must understand log and bus from the served descriptors."""
    files = descriptor_pb2.FileDescriptorSet.FromString(descriptor_set(pb.Stamp))
    pool = descriptor_pool.DescriptorPool()
    for file in files.file:
        pool.Add(file)
    foreign = message_factory.GetMessageClass(pool.FindMessageTypeByName("bumpless.Navigation"))
    payload = pb.Navigation(depth_m=3.25).SerializeToString()
    decoded = foreign.FromString(payload)
    assert decoded.SerializeToString() == payload
    assert "depth_m: 3.25" in str(decoded)
